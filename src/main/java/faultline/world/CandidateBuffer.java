package faultline.world;

import faultline.geometry.ConvexShape;
import java.util.Arrays;

/** A reusable list of shapes, each with its owner; filled without allocation. */
public final class CandidateBuffer {

    private ConvexShape[] shapes = new ConvexShape[64];
    private ShapeOwner[] owners = new ShapeOwner[64];
    private int size;

    /** Creates an empty buffer. */
    public CandidateBuffer() {}

    /** Removes all shapes. */
    public void clear() {
        size = 0;
    }

    void add(ConvexShape shape, ShapeOwner owner) {
        if (size == shapes.length) {
            shapes = Arrays.copyOf(shapes, 2 * size);
            owners = Arrays.copyOf(owners, 2 * size);
        }
        shapes[size] = shape;
        owners[size++] = owner;
    }

    void addAll(PlacedObstacle obstacle) {
        for (ConvexShape part : obstacle.parts()) {
            add(part, obstacle);
        }
    }

    /** Removes the shapes, after the first few, whose owners have been removed from the world. */
    void dropRemoved(int from) {
        int kept = from;
        for (int i = from; i < size; i++) {
            if (!owners[i].isRemoved()) {
                shapes[kept] = shapes[i];
                owners[kept++] = owners[i];
            }
        }
        size = kept;
    }

    /** Removes the shapes that are farther than a radius, metres, from a point. */
    void dropBeyond(double x, double y, double radius) {
        int kept = 0;
        for (int i = 0; i < size; i++) {
            if (shapes[i].distanceTo(x, y) <= radius) {
                shapes[kept] = shapes[i];
                owners[kept++] = owners[i];
            }
        }
        size = kept;
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

    ShapeOwner owner(int index) {
        return owners[index];
    }
}
