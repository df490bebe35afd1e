package faultline.world;

import faultline.geometry.ConvexShape;
import java.util.Arrays;

/** A reusable list of shapes, each with its owner; filled without allocation. */
public final class CandidateBuffer {

    private static final int DEFAULT_CAPACITY = 64;

    private ConvexShape[] shapes;
    private ShapeOwner[] owners;
    private int[] numbers;
    private int size;

    /** Creates an empty buffer. */
    public CandidateBuffer() {
        this(DEFAULT_CAPACITY);
    }

    /** Creates an empty buffer with room for a number of shapes, at least one; it grows when that is exceeded. */
    CandidateBuffer(int capacity) {
        shapes = new ConvexShape[capacity];
        owners = new ShapeOwner[capacity];
        numbers = new int[capacity];
    }

    /** Removes all shapes. */
    public void clear() {
        size = 0;
    }

    void add(ConvexShape shape, ShapeOwner owner) {
        add(shape, owner, size);
    }

    /** Adds the shape of a number in an index. */
    void add(ConvexShape shape, ShapeOwner owner, int number) {
        if (size == shapes.length) {
            grow(2 * size);
        }
        shapes[size] = shape;
        numbers[size] = number;
        owners[size++] = owner;
    }

    /** Adds the shapes of an obstacle by a copy of them all, because a floor plan has tens of thousands. */
    void addAll(PlacedObstacle obstacle) {
        ConvexShape[] parts = obstacle.parts().toArray(new ConvexShape[0]);
        int end = size + parts.length;
        if (end > shapes.length) {
            grow(Math.max(end, 2 * size));
        }
        System.arraycopy(parts, 0, shapes, size, parts.length);
        Arrays.fill(owners, size, end, obstacle);
        for (int i = size; i < end; i++) {
            numbers[i] = i;
        }
        size = end;
    }

    private void grow(int capacity) {
        shapes = Arrays.copyOf(shapes, capacity);
        owners = Arrays.copyOf(owners, capacity);
        numbers = Arrays.copyOf(numbers, capacity);
    }

    /** Removes the shapes, after the first few, whose owners have been removed from the world. */
    void dropRemoved(int from) {
        int kept = from;
        for (int i = from; i < size; i++) {
            if (!owners[i].isRemoved()) {
                copy(i, kept++);
            }
        }
        size = kept;
    }

    /**
     * Removes the shapes that are farther than a radius from a point.
     *
     * @param x metres
     * @param y metres
     * @param radius metres
     */
    public void dropBeyond(double x, double y, double radius) {
        int kept = 0;
        for (int i = 0; i < size; i++) {
            if (shapes[i].distanceTo(x, y) <= radius) {
                copy(i, kept++);
            }
        }
        size = kept;
    }

    private void copy(int from, int to) {
        shapes[to] = shapes[from];
        owners[to] = owners[from];
        numbers[to] = numbers[from];
    }

    /** {@return the number of shapes} */
    public int size() {
        return size;
    }

    /**
     * {@return a shape}
     *
     * @param index the index of the shape, from 0
     */
    public ConvexShape shape(int index) {
        return shapes[index];
    }

    /**
     * {@return the number of a shape in the index that found it}
     *
     * @param index the index of the shape, from 0
     */
    public int number(int index) {
        return numbers[index];
    }

    /** Returns the shapes in a new array. */
    ConvexShape[] shapes() {
        return Arrays.copyOf(shapes, size);
    }

    /** Returns the owners of the shapes in a new array. */
    ShapeOwner[] owners() {
        return Arrays.copyOf(owners, size);
    }

    ShapeOwner owner(int index) {
        return owners[index];
    }
}
