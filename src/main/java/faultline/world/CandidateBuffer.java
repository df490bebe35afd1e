package faultline.world;

import faultline.geometry.ConvexShape;
import java.util.Arrays;

/** A list of figures, each with the obstacle that it belongs to, filled anew every tick without allocating. */
public final class CandidateBuffer {

    private ConvexShape[] shapes = new ConvexShape[64];
    private int[] owners = new int[64];
    private int size;

    public void clear() {
        size = 0;
    }

    void add(ConvexShape figure, int owner) {
        if (size == shapes.length) {
            shapes = Arrays.copyOf(shapes, 2 * size);
            owners = Arrays.copyOf(owners, 2 * size);
        }
        shapes[size] = figure;
        owners[size++] = owner;
    }

    public int size() {
        return size;
    }

    public ConvexShape shape(int index) {
        return shapes[index];
    }

    /** The obstacle that the figure belongs to, by its place in the field. */
    int owner(int index) {
        return owners[index];
    }
}
