package faultline.engine;

import java.util.List;
import java.util.stream.IntStream;

/**
 * Records the robot's path as points at least a spacing apart. If there are too many, points are dropped as far as the
 * shape of the path allows, so that memory stays bounded and corners stay sharp in runs of days.
 */
final class PathRecorder {

    /** The spacing, metres: less than a pixel at any zoom that shows a room. */
    private static final double SPACING = 0.005;

    /** The initial tolerance of thinning, metres: less than a pixel at up to 1000 pixels per metre. */
    private static final double INITIAL_TOLERANCE = 0.001;

    /** The largest number of points: 1.3 km without thinning. */
    static final int MAX_POINTS = 1 << 18;

    private ChunkLog<PathChunk> log = newLog();
    private int size;
    private int thinned;
    private double tolerance = INITIAL_TOLERANCE;
    private double lastX;
    private double lastY;

    private static ChunkLog<PathChunk> newLog() {
        return new ChunkLog<>(PathChunk.CAPACITY, MAX_POINTS / PathChunk.CAPACITY, PathChunk::new);
    }

    /** Records a point if it is far enough from the last one. */
    void record(double x, double y) {
        double dx = x - lastX;
        double dy = y - lastY;
        if (size > 0 && dx * dx + dy * dy < SPACING * SPACING) {
            return;
        }
        if (size == MAX_POINTS) {
            thin();
        }
        add(x, y);
    }

    private void add(double x, double y) {
        int offset = log.append();
        log.newest().set(offset, x, y);
        size++;
        lastX = x;
        lastY = y;
    }

    /** Thins what was recorded since the last time; if too much remains, everything with twice the tolerance. */
    private void thin() {
        RobotPath all = view();
        List<Integer> kept = PathThinner.select(all, Math.max(0, thinned - 1), tolerance);
        int head = Math.max(0, thinned - 1);
        while (head + kept.size() > MAX_POINTS / 2) {
            tolerance *= 2;
            head = 0;
            kept = PathThinner.select(all, 0, tolerance);
        }
        log = newLog();
        size = 0;
        IntStream.concat(IntStream.range(0, head), kept.stream().mapToInt(i -> i))
                .forEach(i -> add(all.x(i), all.y(i)));
        thinned = size;
    }

    /** Returns the path so far. */
    RobotPath view() {
        return new RobotPath(log.view());
    }
}
