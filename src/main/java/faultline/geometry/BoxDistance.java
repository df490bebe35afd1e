package faultline.geometry;

/** The exact distance between a box and a convex figure. Between polygons it is attained at a corner of one of them. */
public final class BoxDistance {

    private static final int CORNERS = 4;

    private BoxDistance() {}

    /**
     * The gap between a box and a figure.
     *
     * @param box the box; its inside belongs to it
     * @param figure the figure; its inside belongs to it
     * @return the gap; of several nearest pairs of points, any one
     */
    public static Separation between(OrientedBox box, ConvexShape figure) {
        if (figure instanceof Segment segment) {
            return toSegment(box, segment);
        }
        return figure instanceof Disc disc ? toDisc(box, disc) : toEllipse(box, (Ellipse) figure);
    }

    private static Separation toSegment(OrientedBox box, Segment segment) {
        Vector2 a = box.toLocal(segment.a());
        Vector2 b = box.toLocal(segment.b());
        Vector2 common = commonPoint(box, a, b);
        if (common != null) {
            Vector2 point = box.toWorld(common);
            return new Separation(0, point, point);
        }
        Separation least = Separation.min(fromPoint(box, segment.a(), a), fromPoint(box, segment.b(), b));
        for (int i = 0; i < CORNERS; i++) {
            least = Separation.min(least, fromCorner(box.corner(i), segment));
        }
        return least;
    }

    private static Separation fromPoint(OrientedBox box, Vector2 point, Vector2 local) {
        Vector2 nearest = box.clamped(local);
        return new Separation(nearest.distanceTo(local), box.toWorld(nearest), point);
    }

    private static Separation fromCorner(Vector2 corner, ConvexShape figure) {
        Vector2 nearest = figure.nearestTo(corner);
        return new Separation(nearest.distanceTo(corner), corner, nearest);
    }

    /**
     * A point of the segment ab inside the box, in the box's frame, or null: the middle of the piece that the four
     * sides leave of it.
     */
    private static Vector2 commonPoint(OrientedBox box, Vector2 a, Vector2 b) {
        double[] share = {0, 1};
        boolean meets = clip(a.x(), b.x() - a.x(), box.halfLength(), share)
                && clip(a.y(), b.y() - a.y(), box.halfWidth(), share);
        if (!meets) {
            return null;
        }
        double middle = (share[0] + share[1]) / 2;
        return new Vector2(a.x() + middle * (b.x() - a.x()), a.y() + middle * (b.y() - a.y()));
    }

    /** Narrows a range of shares to where |start + share * gain| does not exceed a half side. */
    private static boolean clip(double start, double gain, double half, double[] share) {
        if (gain == 0) {
            return Math.abs(start) <= half;
        }
        double one = (-half - start) / gain;
        double other = (half - start) / gain;
        share[0] = Math.max(share[0], Math.min(one, other));
        share[1] = Math.min(share[1], Math.max(one, other));
        return share[0] <= share[1];
    }

    private static Separation toDisc(OrientedBox box, Disc disc) {
        Vector2 centre = box.toLocal(disc.centre());
        Vector2 nearest = box.clamped(centre);
        double distance = nearest.distanceTo(centre);
        if (distance <= disc.radius()) {
            Vector2 point = box.toWorld(nearest);
            return new Separation(0, point, point);
        }
        Vector2 onBox = box.toWorld(nearest);
        return new Separation(distance - disc.radius(), onBox, disc.nearestTo(onBox));
    }

    /**
     * The nearest points of box and ellipse are a corner and its foot, or a point within a side and the ellipse's
     * farthest point towards it.
     */
    private static Separation toEllipse(OrientedBox box, Ellipse oval) {
        Vector2 centre = box.toLocal(oval.centre());
        if (box.clamped(centre).equals(centre)) {
            return new Separation(0, oval.centre(), oval.centre());
        }
        Vector2 deepest = deepestSidePoint(box, oval);
        if (deepest.length() <= 1) {
            Vector2 point = oval.toWorld(new Vector2(oval.rx() * deepest.x(), oval.ry() * deepest.y()));
            return new Separation(0, point, point);
        }
        Separation least = fromCorner(box.corner(0), oval);
        for (int i = 0; i < CORNERS; i++) {
            least = Separation.min(least, fromCorner(box.corner(i), oval));
            Vector2 outward = i % 2 == 0 ? new Vector2(i == 0 ? 1 : -1, 0) : new Vector2(0, i == 1 ? 1 : -1);
            Vector2 support =
                    oval.supportPoint(outward.rotated(box.cos(), box.sin()).times(-1));
            Vector2 local = box.toLocal(support);
            Vector2 nearest = box.clamped(local);
            least = Separation.min(least, new Separation(nearest.distanceTo(local), box.toWorld(nearest), support));
        }
        return least;
    }

    /**
     * The point of the box's sides that lies deepest in the ellipse, with the axes scaled until the ellipse is the unit
     * circle: where the box does not contain the ellipse's centre, the two overlap if that point comes within 1 of the
     * origin.
     */
    private static Vector2 deepestSidePoint(OrientedBox box, Ellipse oval) {
        Vector2 deepest = new Vector2(Double.POSITIVE_INFINITY, 0);
        for (int i = 0; i < CORNERS; i++) {
            Vector2 from = oval.toLocal(box.corner(i));
            Vector2 to = oval.toLocal(box.corner((i + 1) % CORNERS));
            Segment side =
                    new Segment(from.x() / oval.rx(), from.y() / oval.ry(), to.x() / oval.rx(), to.y() / oval.ry());
            Vector2 point = side.nearestTo(Vector2.ZERO);
            deepest = point.length() < deepest.length() ? point : deepest;
        }
        return deepest;
    }
}
