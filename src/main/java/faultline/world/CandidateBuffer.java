package faultline.world;

import faultline.geometry.ConvexShape;
import java.util.Arrays;
import java.util.List;

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
            shapes = Arrays.copyOf(shapes, 2 * size);
            owners = Arrays.copyOf(owners, 2 * size);
            numbers = Arrays.copyOf(numbers, 2 * size);
        }
        shapes[size] = shape;
        numbers[size] = number;
        owners[size++] = owner;
    }

    void addAll(PlacedObstacle obstacle) {
        List<ConvexShape> parts = obstacle.parts();
        for (int i = 0; i < parts.size(); i++) {
            add(parts.get(i), obstacle, size);
        }
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

    /** Removes the shapes that are farther than a radius, metres, from a point. */
    void dropBeyond(double x, double y, double radius) {
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
