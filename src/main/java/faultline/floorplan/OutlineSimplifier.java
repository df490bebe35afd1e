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

    /** A post or a straight wall would lose half of its area with one of its corners. */
    private static final int RECTANGLE_CORNERS = 4;

    /** The corners between two that are kept, and the number of divisions that made this range. */
    private record Range(int from, int to, int depth) {}

    private OutlineSimplifier() {}

    /**
     * Simplifies a ring.
     *
     * @param ring the outline
     * @param tolerance the bound, in cells, not negative
     * @return some of its corners, in their order: at least three, which are not all on a line; a rectangle stays
     */
    public static GridRing simplify(GridRing ring, double tolerance) {
        if (ring.size() <= RECTANGLE_CORNERS) {
            return ring;
        }
        int opposite = farthestFromFirst(ring);
        BitSet kept = new BitSet(ring.size());
        kept.set(0);
        kept.set(opposite);
        Deque<Range> open = new ArrayDeque<>();
        open.push(new Range(0, opposite, 1));
        open.push(new Range(opposite, ring.size(), 1));
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
        // Corners on a line would enclose nothing.
        if (kept.stream().allMatch(corner -> areaWithFirst(ring, opposite, corner) == 0)) {
            kept.set(farthestFromLine(ring, opposite));
        }
        return ring.select(kept.stream().toArray());
    }

    private static int farthestFromFirst(GridRing ring) {
        int farthest = 0;
        double largest = 0;
        for (int i = 1; i < ring.size(); i++) {
            double x = ring.column(i) - ring.column(0);
            double y = ring.row(i) - ring.row(0);
            if (x * x + y * y > largest) {
                largest = x * x + y * y;
                farthest = i;
            }
        }
        return farthest;
    }

    /** Returns the corner that is farthest from the line through the first one and another. */
    private static int farthestFromLine(GridRing ring, int other) {
        int farthest = 0;
        for (int i = 1; i < ring.size(); i++) {
            if (areaWithFirst(ring, other, i) > areaWithFirst(ring, other, farthest)) {
                farthest = i;
            }
        }
        return farthest;
    }

    /** Returns twice the area of the triangle that two corners form with the first one. */
    private static long areaWithFirst(GridRing ring, int a, int b) {
        long ax = ring.column(a) - ring.column(0);
        long ay = ring.row(a) - ring.row(0);
        long bx = ring.column(b) - ring.column(0);
        long by = ring.row(b) - ring.row(0);
        return Math.abs(ax * by - ay * bx);
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
