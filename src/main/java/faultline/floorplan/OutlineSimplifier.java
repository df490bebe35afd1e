package faultline.floorplan;

import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Deque;

/**
 * Replaces the staircase of a slanted wall by straight lines (Douglas and Peucker, 1973): every removed corner is
 * within a bound of the line that replaces it.
 */
public final class OutlineSimplifier {

    /**
     * The number of divisions, one within another, after which ranges are halved. An outline that loses one corner in
     * each division, such as that of a comb, would take quadratic time otherwise.
     */
    private static final int MAX_DEPTH = 501;

    /** The corners between two that are kept, and the number of divisions that made this range. */
    private record Range(int from, int to, int depth) {}

    private OutlineSimplifier() {}

    /**
     * Simplifies a ring.
     *
     * @param ring the outline
     * @param tolerance the bound, in cells, not negative
     * @return some of its corners, in their order; the ring itself if fewer than three would be left
     */
    public static GridRing simplify(GridRing ring, double tolerance) {
        BitSet kept = new BitSet(ring.size());
        kept.set(0);
        Deque<Range> open = new ArrayDeque<>();
        // The chord of the whole ring is its first corner, so that it is divided at the corner farthest from that.
        open.push(new Range(0, ring.size(), 0));
        while (!open.isEmpty()) {
            Range range = open.pop();
            int farthest = farthestFromChord(ring, range, tolerance);
            if (farthest >= 0) {
                int middle = range.depth() < MAX_DEPTH ? farthest : (range.from() + range.to()) / 2;
                kept.set(middle);
                open.push(new Range(range.from(), middle, range.depth() + 1));
                open.push(new Range(middle, range.to(), range.depth() + 1));
            }
        }
        return kept.cardinality() < 3 ? ring : ring.select(kept.stream().toArray());
    }

    /**
     * Returns the corner strictly between two others that is farthest from their chord; -1 if all are within the bound.
     */
    private static int farthestFromChord(GridRing ring, Range range, double tolerance) {
        int end = range.to() % ring.size();
        double x0 = ring.column(range.from());
        double y0 = ring.row(range.from());
        double dx = ring.column(end) - x0;
        double dy = ring.row(end) - y0;
        double lengthSquared = dx * dx + dy * dy;
        int farthest = -1;
        double largest = tolerance * tolerance;
        for (int i = range.from() + 1; i < range.to(); i++) {
            double x = ring.column(i) - x0;
            double y = ring.row(i) - y0;
            double along = lengthSquared == 0 ? 0 : Math.max(0, Math.min(1, (x * dx + y * dy) / lengthSquared));
            double offX = x - along * dx;
            double offY = y - along * dy;
            if (offX * offX + offY * offY > largest) {
                largest = offX * offX + offY * offY;
                farthest = i;
            }
        }
        return farthest;
    }
}
