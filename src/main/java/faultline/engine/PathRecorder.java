package faultline.engine;

/**
 * Records the robot's path as points at least a spacing apart. If there are too many, every second point is dropped and
 * the spacing doubles, so that memory stays bounded.
 */
final class PathRecorder {

    /** The initial spacing, metres: less than a pixel at any zoom that shows a room. */
    private static final double INITIAL_SPACING = 0.005;

    /** The largest number of points: 1.3 km at the initial spacing. */
    static final int MAX_POINTS = 1 << 18;

    private ChunkLog<PathChunk> log = newLog();
    private int size;
    private double spacing = INITIAL_SPACING;
    private double lastX;
    private double lastY;

    private static ChunkLog<PathChunk> newLog() {
        return new ChunkLog<>(PathChunk.CAPACITY, MAX_POINTS / PathChunk.CAPACITY, PathChunk::new);
    }

    /** Records a point if it is far enough from the last one. */
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
        int offset = log.append();
        log.newest().set(offset, x, y);
        size++;
        lastX = x;
        lastY = y;
    }

    private void thin() {
        RobotPath all = view();
        log = newLog();
        size = 0;
        spacing *= 2;
        for (int i = 0; i < all.size(); i += 2) {
            add(all.x(i), all.y(i));
        }
    }

    /** Returns the path so far. */
    RobotPath view() {
        return new RobotPath(log.view());
    }
}
