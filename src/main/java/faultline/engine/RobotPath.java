package faultline.engine;

import java.awt.geom.Rectangle2D;

/**
 * The robot's path so far, as a view of fixed length on a recording that goes on growing: taking one copies nothing,
 * and any thread may read it. Two views of one recording agree wherever both have points, unless it was thinned between
 * them, so a painter may draw only what has been added.
 */
public final class RobotPath {

    private final PathChunk[] chunks;
    private final int size;

    RobotPath(PathChunk[] chunks, int size) {
        this.chunks = chunks;
        this.size = size;
    }

    /**
     * How many points there are.
     *
     * @return at least 1: the start
     */
    public int size() {
        return size;
    }

    /**
     * A point's x.
     *
     * @param index from 0, the start, to size - 1
     * @return metres
     */
    public double x(int index) {
        return chunks[index / PathChunk.CAPACITY].x(index % PathChunk.CAPACITY);
    }

    /**
     * A point's y.
     *
     * @param index from 0, the start, to size - 1
     * @return metres
     */
    public double y(int index) {
        return chunks[index / PathChunk.CAPACITY].y(index % PathChunk.CAPACITY);
    }

    /**
     * How many points from one on can be left out because all of them, and the lines between them, lie outside of a
     * box.
     *
     * @param index from 0 to size - 1
     * @param box metres
     * @return 0 where that is not known at a glance
     */
    public int skippablePoints(int index, Rectangle2D box) {
        boolean whole = index % PathChunk.BLOCK_SIZE == 0 && index + PathChunk.BLOCK_SIZE <= size;
        boolean outside = whole
                && !chunks[index / PathChunk.CAPACITY].blockOverlaps(
                        index % PathChunk.CAPACITY, box.getMinX(), box.getMinY(), box.getMaxX(), box.getMaxY());
        return outside ? PathChunk.BLOCK_SIZE : 0;
    }

    /**
     * Whether this view continues another: same recording, not thinned since, at least as long.
     *
     * @param earlier another view
     * @return true where the first points of this are all of {@code earlier}'s
     */
    public boolean isContinuationOf(RobotPath earlier) {
        return chunks[0] == earlier.chunks[0] && size >= earlier.size;
    }
}
