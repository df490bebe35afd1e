package faultline.engine;

import java.util.Arrays;

/**
 * Records the robot's path by whole points at least a spacing apart. Written by one thread; the views that it gives are
 * for all, because a point once written is never changed and a view is published after its last point. Where there are
 * too many, every second one goes and the spacing doubles, so that a run of days needs no more memory than one of an
 * hour.
 */
final class PathRecorder {

    /** The spacing at first, metres: less than a pixel at any zoom that shows a room. */
    private static final double INITIAL_SPACING = 0.005;

    /** No more points than this are recorded: 1.3 km at the first spacing. */
    static final int MAX_POINTS = 1 << 18;

    private PathChunk[] chunks = new PathChunk[0];
    private int size;
    private double spacing = INITIAL_SPACING;
    private double lastX;
    private double lastY;

    /** Records a point if it lies far enough from the last. */
    void record(double x, double y) {
        double dx = x - lastX;
        double dy = y - lastY;
        if (size > 0 && dx * dx + dy * dy < spacing * spacing) {
            return;
        }
        if (size == MAX_POINTS) {
            thin();
        }
        add(x, y);
    }

    private void add(double x, double y) {
        int chunk = size / PathChunk.CAPACITY;
        if (chunk == chunks.length) {
            chunks = Arrays.copyOf(chunks, chunk + 1);
            chunks[chunk] = new PathChunk();
        }
        chunks[chunk].set(size % PathChunk.CAPACITY, x, y);
        size++;
        lastX = x;
        lastY = y;
    }

    /** Views hold the old chunks, so the thinned ones are others. */
    private void thin() {
        RobotPath all = view();
        chunks = new PathChunk[0];
        size = 0;
        spacing *= 2;
        for (int i = 0; i < all.size(); i += 2) {
            add(all.x(i), all.y(i));
        }
    }

    /** The path so far. */
    RobotPath view() {
        return new RobotPath(chunks, size);
    }
}
