package faultline.geometry;

/** The exact distance between a box and a convex shape. Between polygons it is attained at a corner of one of them. */
public final class BoxDistance {

    private BoxDistance() {}

    /**
     * {@return the separation of a box and a shape, with one of the nearest pairs of points if there are several}
     *
     * @param box the box
     * @param shape the shape, in the same frame
     */
    public static Separation between(OrientedBox box, ConvexShape shape) {
        if (shape instanceof Segment segment) {
            return toSegment(box, segment);
        }
        return shape instanceof Disc disc ? toDisc(box, disc) : toEllipse(box, (Ellipse) shape);
    }

    private static Separation toSegment(OrientedBox box, Segment segment) {
        Vector2 a = box.frame().toLocal(segment.a());
        Vector2 b = box.frame().toLocal(segment.b());
        Vector2 common = commonPoint(box, a, b);
        if (common != null) {
            Vector2 point = box.frame().toParent(common);
            return new Separation(0, point, point);
        }
        Separation least = Separation.min(fromPoint(box, segment.a(), a), fromPoint(box, segment.b(), b));
        for (int i = 0; i < OrientedBox.CORNERS; i++) {
            least = Separation.min(least, fromCorner(box.corner(i), segment));
        }
        return least;
    }

    private static Separation fromPoint(OrientedBox box, Vector2 point, Vector2 local) {
        Vector2 nearest = box.clamp(local);
        return new Separation(nearest.distanceTo(local), box.frame().toParent(nearest), point);
    }

    private static Separation fromCorner(Vector2 corner, ConvexShape shape) {
        Vector2 nearest = shape.nearestTo(corner);
        return new Separation(nearest.distanceTo(corner), corner, nearest);
    }

    /**
     * Returns a point of the segment ab inside the box, in the box's frame, or null: the middle of the part that
     * remains after clipping to the box.
     */
    private static Vector2 commonPoint(OrientedBox box, Vector2 a, Vector2 b) {
        double[] range = {0, 1};
        boolean meets = clip(a.x(), b.x() - a.x(), box.halfLength(), range)
                && clip(a.y(), b.y() - a.y(), box.halfWidth(), range);
        if (!meets) {
            return null;
        }
        double middle = (range[0] + range[1]) / 2;
        return new Vector2(a.x() + middle * (b.x() - a.x()), a.y() + middle * (b.y() - a.y()));
    }

    /** Clips a range of fractions to where |start + fraction * gain| does not exceed a half side. */
    private static boolean clip(double start, double gain, double half, double[] range) {
        if (gain == 0) {
            return Math.abs(start) <= half;
        }
        double one = (-half - start) / gain;
        double other = (half - start) / gain;
        range[0] = Math.max(range[0], Math.min(one, other));
        range[1] = Math.min(range[1], Math.max(one, other));
        return range[0] <= range[1];
    }

    private static Separation toDisc(OrientedBox box, Disc disc) {
        Vector2 centre = box.frame().toLocal(disc.centre());
        Vector2 nearest = box.clamp(centre);
        double distance = nearest.distanceTo(centre);
        if (distance <= disc.radius()) {
            Vector2 point = box.frame().toParent(nearest);
            return new Separation(0, point, point);
        }
        Vector2 onBox = box.frame().toParent(nearest);
        return new Separation(distance - disc.radius(), onBox, disc.nearestTo(onBox));
    }

    /**
     * The nearest points of box and ellipse are a corner and its closest point, or a point of a side and the ellipse's
     * support point towards that side.
     */
    private static Separation toEllipse(OrientedBox box, Ellipse ellipse) {
        Vector2 centre = box.frame().toLocal(ellipse.centre());
        if (box.clamp(centre).equals(centre)) {
            return new Separation(0, ellipse.centre(), ellipse.centre());
        }
        Vector2 deepest = deepestSidePoint(box, ellipse);
        if (deepest.length() <= 1) {
            Vector2 point =
                    ellipse.frame().toParent(new Vector2(ellipse.rx() * deepest.x(), ellipse.ry() * deepest.y()));
            return new Separation(0, point, point);
        }
        Separation least = new Separation(Double.POSITIVE_INFINITY, Vector2.ZERO, Vector2.ZERO);
        for (int i = 0; i < OrientedBox.CORNERS; i++) {
            least = Separation.min(least, fromCorner(box.corner(i), ellipse));
            Vector2 outward = i % 2 == 0 ? new Vector2(i == 0 ? 1 : -1, 0) : new Vector2(0, i == 1 ? 1 : -1);
            Vector2 support = ellipse.supportPoint(
                    outward.rotated(box.frame().cos(), box.frame().sin()).times(-1));
            Vector2 local = box.frame().toLocal(support);
            Vector2 nearest = box.clamp(local);
            least = Separation.min(
                    least, new Separation(nearest.distanceTo(local), box.frame().toParent(nearest), support));
        }
        return least;
    }

    /**
     * Returns the point of the box's sides nearest to the ellipse's centre, in coordinates in which the ellipse is the
     * unit circle. If the box does not contain the ellipse's centre, the two overlap if and only if that point is
     * within 1 of the origin.
     */
    private static Vector2 deepestSidePoint(OrientedBox box, Ellipse ellipse) {
        Vector2 deepest = new Vector2(Double.POSITIVE_INFINITY, 0);
        for (int i = 0; i < OrientedBox.CORNERS; i++) {
            Segment side = new Segment(
                    ellipse.toUnitCircle(box.corner(i)),
                    ellipse.toUnitCircle(box.corner((i + 1) % OrientedBox.CORNERS)));
            Vector2 point = side.nearestTo(Vector2.ZERO);
            deepest = point.length() < deepest.length() ? point : deepest;
        }
        return deepest;
    }
}
