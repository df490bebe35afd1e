package faultline.engine;

import faultline.geometry.Vector2;
import java.awt.geom.Rectangle2D;
import java.util.List;

/**
 * The robot's path up to one moment. Any thread may read it. A later path of the same run begins with the same points
 * unless the recorder has dropped some, so a painter may draw only the new ones; see {@link #isContinuationOf}.
 */
public final class RobotPath {

    private final ChunkLog.View<PathChunk> points;

    private final PathThinning nextThinning;

    RobotPath(ChunkLog.View<PathChunk> points, PathThinning nextThinning) {
        this.points = points;
        this.nextThinning = nextThinning;
    }

    /** {@return the number of points, at least 1} */
    public int size() {
        return (int) points.end();
    }

    /**
     * {@return the x coordinate of a point, metres; point 0 is the start, or the oldest of a long path}
     *
     * @param index the index of the point
     */
    public double x(int index) {
        return points.chunk(index).x(points.offset(index));
    }

    /**
     * {@return the y coordinate of a point, metres; point 0 is the start, or the oldest of a long path}
     *
     * @param index the index of the point
     */
    public double y(int index) {
        return points.chunk(index).y(points.offset(index));
    }

    /**
     * {@return the {@link PathTag} of the line that leads to a point}
     *
     * @param index the index of the point
     */
    public int tag(int index) {
        return points.chunk(index).tag(points.offset(index));
    }

    /**
     * {@return the points in order without those that are close to a line through the others, the first and the last
     * one included}
     *
     * @param tolerance the maximum distance of an omitted point from the lines between the others, metres
     */
    public List<Vector2> simplified(double tolerance) {
        return PathThinner.select(this, 0, tolerance).stream()
                .map(index -> new Vector2(x(index), y(index)))
                .toList();
    }

    /**
     * Returns the number of points from an index on that can be skipped because they, and the lines between them, lie
     * outside a box.
     *
     * @param index not negative, less than {@link #size}
     * @param box metres
     * @return 0 if that would need a closer look
     */
    public int skippablePoints(int index, Rectangle2D box) {
        boolean whole = index % PathChunk.BLOCK_SIZE == 0 && index + PathChunk.BLOCK_SIZE <= size();
        boolean outside = whole
                && !points.chunk(index)
                        .blockOverlaps(
                                points.offset(index), box.getMinX(), box.getMinY(), box.getMaxX(), box.getMaxY());
        return outside ? PathChunk.BLOCK_SIZE : 0;
    }

    /**
     * {@return the part of this path that an earlier path of the same run covered, at least its first point} It shares
     * its points with this path, while the earlier path may hold points that have been dropped since.
     *
     * @param earlier the earlier path
     */
    public RobotPath prefix(RobotPath earlier) {
        int size = Math.max(1, earlier.nextThinning.sizeAfter(earlier.size(), nextThinning));
        return new RobotPath(
                new ChunkLog.View<>(points.chunks(), points.chunkSize(), points.first(), size), nextThinning);
    }

    /**
     * {@return whether this path begins with all points of an earlier path of the same run}
     *
     * @param earlier the earlier path
     */
    public boolean isContinuationOf(RobotPath earlier) {
        return points.isContinuationOf(earlier.points);
    }
}
