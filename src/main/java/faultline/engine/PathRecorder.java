package faultline.engine;

import java.util.Arrays;

/**
 * Records the robot's path by whole points at least a spacing apart. Written by one thread; the views that it gives are for all, because a point
 * once written is never changed and a view is published after its last point. The spacing keeps a long run's memory in bounds.
 */
final class PathRecorder {

    /** How many points one chunk holds. */
    static final int CHUNK = 4096;

    /** No two recorded points are nearer than this, metres: less than a pixel at any zoom that shows a room. */
    private static final double SPACING = 0.005;

    /** No more points than this are recorded: some 5 km at the spacing. */
    private static final int MOST = 1 << 20;

    private double[][] chunks = new double[0][];
    private int size;
    private double lastX;
    private double lastY;

    /** Records a point if it lies far enough from the last. */
    void record(double x, double y) {
        double dx = x - lastX;
        double dy = y - lastY;
        if (size > 0 && dx * dx + dy * dy < SPACING * SPACING || size == MOST) {
            return;
        }
        int chunk = size / CHUNK;
        if (chunk == chunks.length) {
            chunks = Arrays.copyOf(chunks, chunk + 1);
            chunks[chunk] = new double[2 * CHUNK];
        }
        chunks[chunk][2 * (size % CHUNK)] = x;
        chunks[chunk][2 * (size % CHUNK) + 1] = y;
        size++;
        lastX = x;
        lastY = y;
    }

    /** The path so far. */
    Path view() {
        return new Path(this, chunks, size);
    }
}
