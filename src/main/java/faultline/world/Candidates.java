package faultline.world;

import faultline.geometry.Convex;
import java.util.Arrays;

/** A list of figures, each with the obstacle that it belongs to, filled anew every tick without allocating. */
final class Candidates {

    private Convex[] figures = new Convex[64];
    private int[] owners = new int[64];
    private int size;

    void clear() {
        size = 0;
    }

    void add(Convex figure, int owner) {
        if (size == figures.length) {
            figures = Arrays.copyOf(figures, 2 * size);
            owners = Arrays.copyOf(owners, 2 * size);
        }
        figures[size] = figure;
        owners[size++] = owner;
    }

    int size() {
        return size;
    }

    Convex figure(int index) {
        return figures[index];
    }

    /** The obstacle that the figure belongs to, by its place in the field. */
    int owner(int index) {
        return owners[index];
    }
}
