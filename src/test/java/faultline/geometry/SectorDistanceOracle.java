package faultline.geometry;

/**
 * An independent oracle of sector readings: the nearest of all rays in the sector, found by search instead of a
 * formula.
 *
 * <p>Along a ray from the apex a convex figure begins at some distance. Over the rays of the fan that distance has one
 * valley, because the part of the figure within any distance is convex, so its rays are an interval; ternary search
 * finds the bottom. A segment, whose valley may be one single ray, is cut by the two edges instead and searched along
 * itself.
 *
 * <p>Where the figure merely touches an edge or the arc, or the apex lies on its outline, the true reading jumps, and
 * rounding alone decides on which side an answer falls. The oracle therefore gives two readings, of a sector that is
 * wider and of one that is narrower: its edges turned by {@link #EDGE_ROTATION} and shifted by some rounding.
 * Everywhere else the two agree.
 */
public final class SectorDistanceOracle {

    private static final double NONE = Double.POSITIVE_INFINITY;
    private static final int STEPS = 120;
    private static final double EDGE_ROTATION = 1e-12;

    private final ConvexShape figure;
    private final Vector2 apex;
    private final Vector2 right;
    private final Vector2 left;

    private SectorDistanceOracle(Sector sector, ConvexShape figure, double turn, double forward) {
        this.figure = figure;
        this.apex = sector.apex().plus(sector.axis().times(forward));
        this.right = sector.rightEdge().rotated(Math.cos(turn), -Math.sin(turn));
        this.left = sector.leftEdge().rotated(Math.cos(turn), Math.sin(turn));
    }

    /**
     * What a reading may be.
     *
     * @param min the reading of the wider sector, metres
     * @param max the reading of the narrower sector, metres, not less
     */
    public record Bounds(double min, double max) {

        /** Whether a reading is right within a tolerance. */
        public boolean contains(double reading, double tolerance) {
            return reading >= min - tolerance && reading <= max + tolerance;
        }

        /** Whether the two sectors agree, so that there is one right answer. */
        public boolean isTight(double tolerance) {
            return min == max || max - min <= tolerance;
        }
    }

    /** What the reading of a figure in a sector may be. */
    public static Bounds bounds(Sector sector, ConvexShape figure) {
        double gap = distanceBound(figure, sector.apex());
        double scale = Math.max(
                1e-3 * sector.range(), sector.apex().length() + figure.centre().length() + figure.boundingRadius());
        double rounding = 1e-14 * scale;
        if (gap < -rounding) {
            return new Bounds(0, 0);
        }
        // Moving the apex by this much along the axis moves each edge by the rounding, and a distance from it by no
        // more than this.
        double shift = rounding / sector.sinHalf();
        double wide =
                gap < rounding ? 0 : new SectorDistanceOracle(sector, figure, EDGE_ROTATION, -shift).nearest() - shift;
        double narrow = new SectorDistanceOracle(sector, figure, -EDGE_ROTATION, shift).nearest() + shift;
        double slack = 1e-12 * sector.range() + rounding;
        return new Bounds(limitedTo(sector.range() + slack, wide), limitedTo(sector.range() - slack, narrow));
    }

    private static double limitedTo(double range, double distance) {
        return distance <= range ? distance : NONE;
    }

    /** A lower bound of how far a point lies outside a figure, metres; negative inside. */
    private static double distanceBound(ConvexShape figure, Vector2 point) {
        if (figure instanceof Segment segment) {
            return minimumDistance(segment.a().minus(point), segment.b().minus(point), 0, 1);
        }
        if (figure.boundingRadius() == 0) {
            return figure.centre().distanceTo(point);
        }
        Ellipse oval = asEllipse(figure);
        Vector2 local = oval.frame().toLocal(point);
        double level = Math.hypot(local.x() / oval.rx(), local.y() / oval.ry());
        return (level - 1) * Math.min(oval.rx(), oval.ry());
    }

    private static Ellipse asEllipse(ConvexShape figure) {
        return figure instanceof Ellipse oval ? oval : ((Disc) figure).toEllipse();
    }

    private double nearest() {
        return figure.boundingRadius() == 0
                ? nearestPoint()
                : figure instanceof Segment segment ? nearestOnSegment(segment) : nearestRay();
    }

    private double nearestPoint() {
        Vector2 p = figure.centre().minus(apex);
        return right.cross(p) >= 0 && p.cross(left) >= 0 ? p.length() : NONE;
    }

    private double nearestOnSegment(Segment segment) {
        Vector2 a = segment.a().minus(apex);
        Vector2 b = segment.b().minus(apex);
        double[] part = {0, 1};
        clip(part, right.cross(a), right.cross(b));
        clip(part, a.cross(left), b.cross(left));
        return part[0] > part[1] ? NONE : minimumDistance(a, b, part[0], part[1]);
    }

    private static double minimumDistance(Vector2 a, Vector2 b, double from, double to) {
        double low = from;
        double high = to;
        for (int step = 0; step < STEPS; step++) {
            double first = low + (high - low) / 3;
            double second = high - (high - low) / 3;
            if (distanceAt(a, b, first) <= distanceAt(a, b, second)) {
                high = second;
            } else {
                low = first;
            }
        }
        return Math.min(distanceAt(a, b, low), Math.min(distanceAt(a, b, from), distanceAt(a, b, to)));
    }

    private static double distanceAt(Vector2 a, Vector2 b, double share) {
        return a.times(1 - share).plus(b.times(share)).length();
    }

    /** Keeps the part of [0, 1] where a linear function, given at 0 and at 1, is not negative. */
    private static void clip(double[] part, double atStart, double atEnd) {
        if (atStart < 0 && atEnd < 0) {
            part[0] = 2;
        } else if (atStart < 0) {
            part[0] = Math.max(part[0], atStart / (atStart - atEnd));
        } else if (atEnd < 0) {
            part[1] = Math.min(part[1], atStart / (atStart - atEnd));
        }
    }

    private double nearestRay() {
        if (distanceBound(figure, apex) <= 0) {
            return 0;
        }
        Vector2 middle = figure.centre().minus(apex);
        double fromRight = right.cross(middle);
        double fromLeft = left.cross(middle);
        double best = Math.min(firstHit(0), firstHit(1));
        if (fromRight > 0 && fromLeft < 0) {
            double towards = fromRight / (fromRight - fromLeft);
            best = Math.min(best, Math.min(valleyMinimum(towards, 0), valleyMinimum(towards, 1)));
        } else if (best < NONE) {
            best = Math.min(best, firstHit(0) < NONE ? valleyMinimum(0, 1) : valleyMinimum(1, 0));
        }
        return best;
    }

    /** The lowest value from a ray that hits towards an edge of the fan, beyond the hits of which there are none. */
    private double valleyMinimum(double hitting, double edge) {
        double low = hitting;
        double high = edge;
        double best = firstHit(hitting);
        for (int step = 0; step < STEPS; step++) {
            double first = low + (high - low) / 3;
            double second = high - (high - low) / 3;
            double atFirst = firstHit(first);
            double atSecond = firstHit(second);
            best = Math.min(best, Math.min(atFirst, atSecond));
            if (atFirst <= atSecond) {
                high = second;
            } else {
                low = first;
            }
        }
        return best;
    }

    /**
     * Returns where a ray, given by its position between the right edge (0) and the left (1), first intersects the
     * ellipse; the apex is outside it.
     */
    private double firstHit(double share) {
        Vector2 ray = right.times(1 - share).plus(left.times(share));
        Ellipse oval = asEllipse(figure);
        Vector2 from = oval.frame().toLocal(apex);
        Vector2 along = new Vector2(
                oval.frame().cos() * ray.x() + oval.frame().sin() * ray.y(),
                oval.frame().cos() * ray.y() - oval.frame().sin() * ray.x());
        Vector2 o = new Vector2(from.x() / oval.rx(), from.y() / oval.ry());
        Vector2 w = new Vector2(along.x() / oval.rx(), along.y() / oval.ry());
        double miss = o.cross(w);
        double under = (w.length() - miss) * (w.length() + miss);
        double back = -o.dot(w);
        return under < 0 || back < 0 ? NONE : (back - Math.sqrt(under)) / w.dot(w) * ray.length();
    }
}
