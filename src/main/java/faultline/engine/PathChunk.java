package faultline.engine;

/**
 * Consecutive points of a path, with bounding boxes of blocks of them, by which a painter skips what is not in view.
 */
final class PathChunk {

    /** The number of points of a chunk. */
    static final int CAPACITY = 4096;

    /** The number of points of a block. */
    static final int BLOCK_SIZE = 64;

    private static final int BOX_SIDES = 4;

    private final double[] xy = new double[2 * CAPACITY];
    private final byte[] tags = new byte[CAPACITY];
    private final double[] boxes = new double[CAPACITY / BLOCK_SIZE * BOX_SIDES];

    /** Writes the next point. */
    void set(int index, double x, double y, int tag) {
        tags[index] = (byte) tag;
        xy[2 * index] = x;
        xy[2 * index + 1] = y;
        int box = index / BLOCK_SIZE * BOX_SIDES;
        boolean first = index % BLOCK_SIZE == 0;
        boxes[box] = first ? x : Math.min(boxes[box], x);
        boxes[box + 1] = first ? y : Math.min(boxes[box + 1], y);
        boxes[box + 2] = first ? x : Math.max(boxes[box + 2], x);
        boxes[box + 3] = first ? y : Math.max(boxes[box + 3], y);
    }

    int tag(int index) {
        return tags[index];
    }

    double x(int index) {
        return xy[2 * index];
    }

    double y(int index) {
        return xy[2 * index + 1];
    }

    /** Returns whether the bounding box of a complete block overlaps another box. */
    boolean blockOverlaps(int index, double minX, double minY, double maxX, double maxY) {
        int box = index / BLOCK_SIZE * BOX_SIDES;
        return boxes[box] <= maxX && boxes[box + 1] <= maxY && boxes[box + 2] >= minX && boxes[box + 3] >= minY;
    }
}
