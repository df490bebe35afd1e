package faultline.geometry;

/** The exact distance between a box and a convex figure. Between polygons it is attained at a corner of one of them. */
public final class BoxGap {

    private static final int CORNERS = 4;

    private BoxGap() {
    }

    /**
     * The gap between a box and a figure.
     *
     * @param box the box; its inside belongs to it
     * @param figure the figure; its inside belongs to it
     * @return the gap; of several nearest pairs of points, any one
     */
    public static Gap between(Box box, Convex figure) {
        if (figure instanceof Segment segment) {
            return toSegment(box, segment);
        }
        return figure instanceof Disc disc ? toDisc(box, disc) : toOval(box, (Oval) figure);
    }

    private static Gap toSegment(Box box, Segment segment) {
        Vec a = box.toLocal(segment.a());
        Vec b = box.toLocal(segment.b());
        Vec common = commonPoint(box, a, b);
        if (common != null) {
            Vec point = box.toWorld(common);
            return new Gap(0, point, point);
        }
        Gap least = Gap.smaller(fromPoint(box, segment.a(), a), fromPoint(box, segment.b(), b));
        for (int i = 0; i < CORNERS; i++) {
            least = Gap.smaller(least, fromCorner(box.corner(i), segment));
        }
        return least;
    }

    private static Gap fromPoint(Box box, Vec point, Vec local) {
        Vec nearest = box.clamped(local);
        return new Gap(nearest.distanceTo(local), box.toWorld(nearest), point);
    }

    private static Gap fromCorner(Vec corner, Convex figure) {
        Vec nearest = figure.nearestTo(corner);
        return new Gap(nearest.distanceTo(corner), corner, nearest);
    }

    /** A point of the segment ab inside the box, in the box's frame, or null: the middle of the piece that the four sides leave of it. */
    private static Vec commonPoint(Box box, Vec a, Vec b) {
        double[] share = {0, 1};
        boolean meets = clip(a.x(), b.x() - a.x(), box.halfLength(), share) && clip(a.y(), b.y() - a.y(), box.halfWidth(), share);
        if (!meets) {
            return null;
        }
        double middle = (share[0] + share[1]) / 2;
        return new Vec(a.x() + middle * (b.x() - a.x()), a.y() + middle * (b.y() - a.y()));
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

    private static Gap toDisc(Box box, Disc disc) {
        Vec centre = box.toLocal(disc.centre());
        Vec nearest = box.clamped(centre);
        double distance = nearest.distanceTo(centre);
        if (distance <= disc.radius()) {
            Vec point = box.toWorld(nearest);
            return new Gap(0, point, point);
        }
        Vec onBox = box.toWorld(nearest);
        return new Gap(distance - disc.radius(), onBox, disc.nearestTo(onBox));
    }

    /**
     * The nearest points of box and ellipse are a corner and its foot, or a point within a side and the ellipse's farthest point towards
     * it.
     */
    private static Gap toOval(Box box, Oval oval) {
        Vec centre = box.toLocal(oval.centre());
        if (box.clamped(centre).equals(centre)) {
            return new Gap(0, oval.centre(), oval.centre());
        }
        Vec deepest = deepestSidePoint(box, oval);
        if (deepest.length() <= 1) {
            Vec point = oval.toWorld(new Vec(oval.rx() * deepest.x(), oval.ry() * deepest.y()));
            return new Gap(0, point, point);
        }
        Gap least = fromCorner(box.corner(0), oval);
        for (int i = 0; i < CORNERS; i++) {
            least = Gap.smaller(least, fromCorner(box.corner(i), oval));
            Vec outward = i % 2 == 0 ? new Vec(i == 0 ? 1 : -1, 0) : new Vec(0, i == 1 ? 1 : -1);
            Vec support = oval.support(outward.turned(box.cos(), box.sin()).times(-1));
            Vec local = box.toLocal(support);
            Vec nearest = box.clamped(local);
            least = Gap.smaller(least, new Gap(nearest.distanceTo(local), box.toWorld(nearest), support));
        }
        return least;
    }

    /**
     * The point of the box's sides that lies deepest in the ellipse, with the axes scaled until the ellipse is the unit circle: where the
     * box does not contain the ellipse's centre, the two overlap if that point comes within 1 of the origin.
     */
    private static Vec deepestSidePoint(Box box, Oval oval) {
        Vec deepest = new Vec(Double.POSITIVE_INFINITY, 0);
        for (int i = 0; i < CORNERS; i++) {
            Vec from = oval.toLocal(box.corner(i));
            Vec to = oval.toLocal(box.corner((i + 1) % CORNERS));
            Segment side = new Segment(from.x() / oval.rx(), from.y() / oval.ry(), to.x() / oval.rx(), to.y() / oval.ry());
            Vec point = side.nearestTo(Vec.ZERO);
            deepest = point.length() < deepest.length() ? point : deepest;
        }
        return deepest;
    }
}
