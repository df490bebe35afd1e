package faultline.engine;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Records the robot's path as points at least a spacing apart. If there are too many, points are dropped as far as the
 * shape of the path allows, and then the oldest ones, so that memory stays bounded and the recorded path stays accurate
 * even in a run of days.
 */
final class PathRecorder {

    /** The spacing, metres: less than a pixel at any zoom that shows a room. */
    private static final double SPACING = 0.005;

    /** The spacing of points at which the tag changes, metres. */
    private static final double TAG_SPACING = 0.001;

    /** The initial tolerance of thinning, metres: less than a pixel at up to 1000 pixels per metre. */
    private static final double INITIAL_TOLERANCE = 0.001;

    /** The largest tolerance, metres: about a pixel in a view of a room. */
    private static final double MAX_TOLERANCE = 0.016;

    /** The largest number of points: 1.3 km without thinning. */
    static final int MAX_POINTS = 1 << 18;

    private ChunkLog<PathChunk> log = newLog();
    private int size;
    private int thinned;
    private PathThinning nextThinning = new PathThinning();
    private double tolerance = INITIAL_TOLERANCE;
    private double lastX;
    private double lastY;
    private int lastTag;

    private static ChunkLog<PathChunk> newLog() {
        return new ChunkLog<>(PathChunk.CAPACITY, MAX_POINTS / PathChunk.CAPACITY, PathChunk::new);
    }

    /** Records a point if it is far enough from the last one; see {@link PathTag}. */
    void record(double x, double y, int tag) {
        double dx = x - lastX;
        double dy = y - lastY;
        double spacing = tag == lastTag ? SPACING : TAG_SPACING;
        if (size > 0 && dx * dx + dy * dy < spacing * spacing) {
            return;
        }
        if (size == MAX_POINTS) {
            thin();
        }
        add(x, y, tag);
    }

    private void add(double x, double y, int tag) {
        int offset = log.append();
        log.newest().set(offset, x, y, tag);
        lastTag = tag;
        size++;
        lastX = x;
        lastY = y;
    }

    /**
     * Thins what was recorded since the last time. If too much remains, thins everything with twice the tolerance, and
     * at the largest tolerance drops the oldest points.
     */
    private void thin() {
        RobotPath all = view();
        List<Integer> kept = select(all, Math.max(0, thinned - 1));
        int head = Math.max(0, thinned - 1);
        while (head + kept.size() > MAX_POINTS / 2 && tolerance < MAX_TOLERANCE) {
            tolerance *= 2;
            head = 0;
            kept = select(all, 0);
        }
        log = newLog();
        size = 0;
        int[] selected = IntStream.concat(
                        IntStream.range(0, head), kept.stream().mapToInt(i -> i))
                .toArray();
        int[] indexes = Arrays.copyOfRange(selected, Math.max(0, selected.length - MAX_POINTS / 2), selected.length);
        for (int i : indexes) {
            add(all.x(i), all.y(i), all.tag(i));
        }
        nextThinning = nextThinning.happened(indexes);
        thinned = size;
    }

    private List<Integer> select(RobotPath path, int from) {
        return PathThinner.select(path, from, tolerance);
    }

    /** Returns the path so far. */
    RobotPath view() {
        return new RobotPath(log.view(), nextThinning);
    }
}
