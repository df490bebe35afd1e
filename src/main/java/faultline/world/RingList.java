package faultline.world;

import faultline.geometry.ConvexShape;
import faultline.geometry.EvenOddRule;
import faultline.geometry.RigidMotion;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import java.util.AbstractList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.RandomAccess;

/**
 * The rings of a floor plan, immutable. The coordinates of all points are in two arrays, because the plan of a building
 * has tens of thousands: loops over the sides, each from a point to the next one of its ring, create no objects.
 */
final class RingList extends AbstractList<List<Vector2>> implements RandomAccess {

    private final double[] xs;
    private final double[] ys;
    /** The index of the point after each one in its ring. */
    private final int[] next;
    /** The index of the first point of each ring, and the number of all points. */
    private final int[] starts;

    private RingList(double[] xs, double[] ys, int[] starts) {
        this.xs = xs;
        this.ys = ys;
        this.starts = starts;
        next = new int[xs.length];
        for (int ring = 1; ring < starts.length; ring++) {
            int first = starts[ring - 1];
            int last = starts[ring] - 1;
            for (int i = first; i < last; i++) {
                next[i] = i + 1;
            }
            next[last] = first;
        }
    }

    /**
     * Returns a copy of some rings, or the list itself if it is of this class.
     *
     * @throws IllegalArgumentException if there is no ring, a ring has fewer than three points, or a point is not
     *     finite
     */
    static RingList copyOf(List<List<Vector2>> rings) {
        if (rings instanceof RingList known) {
            return known;
        }
        int[] starts = new int[rings.size() + 1];
        for (int ring = 0; ring < rings.size(); ring++) {
            starts[ring + 1] = starts[ring] + rings.get(ring).size();
        }
        double[] xs = new double[starts[rings.size()]];
        double[] ys = new double[xs.length];
        int side = 0;
        for (List<Vector2> ring : rings) {
            for (Vector2 point : ring) {
                xs[side] = point.x();
                ys[side++] = point.y();
            }
        }
        return of(xs, ys, starts);
    }

    /**
     * Returns the rings of points that are given by their coordinates.
     *
     * @param starts the index of the first point of each ring, and last the number of all points
     * @throws IllegalArgumentException if there is no ring, a ring has fewer than three points, a point is not finite,
     *     or the lengths of the arrays differ
     */
    static RingList of(double[] xs, double[] ys, int[] starts) {
        RingList rings = new RingList(xs.clone(), ys.clone(), requireStarts(starts.clone(), xs.length));
        if (xs.length != ys.length) {
            throw new IllegalArgumentException("a plan needs two coordinates for each point");
        }
        for (int i = 0; i < rings.sides(); i++) {
            if (!Double.isFinite(rings.xs[i]) || !Double.isFinite(rings.ys[i])) {
                throw new IllegalArgumentException("the points of a plan must be finite: " + rings.point(i));
            }
        }
        return rings;
    }

    private static int[] requireStarts(int[] starts, int points) {
        if (starts.length < 2) {
            throw new IllegalArgumentException("a plan needs at least one ring");
        }
        if (starts[0] != 0 || starts[starts.length - 1] != points) {
            throw new IllegalArgumentException("the rings of a plan must have all of its points");
        }
        for (int ring = 1; ring < starts.length; ring++) {
            int size = starts[ring] - starts[ring - 1];
            if (size < 3) {
                throw new IllegalArgumentException("a ring of a plan needs at least 3 points: " + size);
            }
        }
        return starts;
    }

    /** Returns the number of sides of all rings, and of points. */
    int sides() {
        return xs.length;
    }

    /** Returns the point from which a side goes. */
    Vector2 point(int side) {
        return new Vector2(xs[side], ys[side]);
    }

    /** Returns all sides in the parent of a frame. It computes each point once, and creates nothing but the sides. */
    ConvexShape[] segments(RigidMotion frame) {
        double[] parentXs = new double[xs.length];
        double[] parentYs = new double[xs.length];
        double cos = frame.cos();
        double sin = frame.sin();
        double x = frame.x();
        double y = frame.y();
        for (int i = 0; i < xs.length; i++) {
            parentXs[i] = x + cos * xs[i] - sin * ys[i];
            parentYs[i] = y + sin * xs[i] + cos * ys[i];
        }
        ConvexShape[] segments = new ConvexShape[xs.length];
        for (int i = 0; i < segments.length; i++) {
            segments[i] = new Segment(parentXs[i], parentYs[i], parentXs[next[i]], parentYs[next[i]]);
        }
        return segments;
    }

    /** Returns some of the sides in the parent of a frame. */
    ConvexShape[] segments(RigidMotion frame, int[] sides) {
        ConvexShape[] segments = new ConvexShape[sides.length];
        for (int i = 0; i < sides.length; i++) {
            segments[i] = new Segment(frame.toParent(point(sides[i])), frame.toParent(point(next[sides[i]])));
        }
        return segments;
    }

    /** Returns whether a point is inside by the even-odd rule. */
    boolean contains(double x, double y) {
        boolean inside = false;
        for (int side = 0; side < xs.length; side++) {
            inside ^= crosses(x, y, side);
        }
        return inside;
    }

    private boolean crosses(double x, double y, int side) {
        int end = next[side];
        return EvenOddRule.crosses(x, y, xs[side], ys[side], xs[end], ys[end]);
    }

    /**
     * Returns what tells whether points of a square about a point, of half a side, are inside, as {@link #contains}
     * does. It looks at the sides near the square only.
     */
    Neighbourhood around(Vector2 centre, double reach) {
        return new Neighbourhood(this, centre, reach);
    }

    /** Returns the greatest distance of a point from the origin, metres. */
    double maxLength() {
        double most = 0;
        for (int i = 0; i < xs.length; i++) {
            double square = xs[i] * xs[i] + ys[i] * ys[i];
            most = square > most ? square : most;
        }
        return Math.sqrt(most);
    }

    /** Returns, in ascending order, the sides whose bounding boxes touch a square about a point, of half a side. */
    int[] sidesNear(Vector2 centre, double reach) {
        double left = centre.x() - reach;
        double right = centre.x() + reach;
        double bottom = centre.y() - reach;
        double top = centre.y() + reach;
        int[] near = new int[xs.length];
        int count = 0;
        for (int a = 0; a < xs.length; a++) {
            int b = next[a];
            if ((xs[a] >= left || xs[b] >= left)
                    && (xs[a] <= right || xs[b] <= right)
                    && (ys[a] >= bottom || ys[b] >= bottom)
                    && (ys[a] <= top || ys[b] <= top)) {
                near[count++] = a;
            }
        }
        return Arrays.copyOf(near, count);
    }

    /**
     * The inside of a plan near a point; immutable.
     *
     * <p>On the way from the centre to another point, a side far from both changes the number of crossings of the ray
     * only where an end of it passes the height of the point, to the right of the centre. Each end belongs to two
     * sides, so these changes cancel out if the ends of the near sides are counted the same way. What remains of the
     * far sides is their number of crossings of the ray from the centre.
     */
    static final class Neighbourhood {

        /** Sides that are at least this far from the square are far, metres: more than rounding can hide. */
        private static final double MARGIN = 1e-6;

        private final RingList rings;
        private final int[] near;
        private final Vector2 centre;
        /** Whether the ray from the centre crosses an odd number of far sides. */
        private final boolean farCrossings;

        Neighbourhood(RingList rings, Vector2 centre, double reach) {
            this.rings = rings;
            this.centre = centre;
            near = rings.sidesNear(centre, reach + MARGIN);
            boolean odd = rings.contains(centre.x(), centre.y());
            for (int side : near) {
                odd ^= rings.crosses(centre.x(), centre.y(), side);
            }
            farCrossings = odd;
        }

        boolean contains(double x, double y) {
            boolean inside = farCrossings;
            for (int side : near) {
                inside ^= rings.crosses(x, y, side) ^ isPassed(side, y) ^ isPassed(rings.next[side], y);
            }
            return inside;
        }

        /** Returns whether a point to the right is at a height between that of the centre and another. */
        private boolean isPassed(int point, double y) {
            double height = rings.ys[point];
            return rings.xs[point] > centre.x() && height > centre.y() != height > y;
        }
    }

    @Override
    public int size() {
        return starts.length - 1;
    }

    @Override
    public List<Vector2> get(int index) {
        return new PlanRing(starts[index], starts[index + 1] - starts[index]);
    }

    /** The points of one ring. */
    private final class PlanRing extends AbstractList<Vector2> implements RandomAccess {
        private final int start;
        private final int size;

        PlanRing(int start, int size) {
            this.start = start;
            this.size = size;
        }

        @Override
        public int size() {
            return size;
        }

        @Override
        public Vector2 get(int index) {
            return point(start + Objects.checkIndex(index, size));
        }
    }
}
