package faultline.geometry;

import java.util.ArrayList;
import java.util.List;

/**
 * The points where a sector's outline (two edges and an arc) meets the outline of a shape, as circled in the paper's
 * figures. They are only drawn; no reading depends on them.
 */
public final class SectorIntersections {

    private SectorIntersections() {}

    /**
     * {@return the points where the outlines cross: those of the left edge, the right edge and the arc, in this order}
     * Points where the outlines only touch, or coincide, may be missing.
     *
     * @param sector the sector
     * @param shape the shape, in the same frame
     */
    public static List<Vector2> points(Sector sector, ConvexShape shape) {
        List<Vector2> hits = new ArrayList<>();
        if (shape instanceof Segment segment) {
            edgeWithSegment(sector, sector.leftEdge(), segment, hits);
            edgeWithSegment(sector, sector.rightEdge(), segment, hits);
            arcWithSegment(sector, segment, hits);
        } else if (!(shape instanceof Disc disc && disc.radius() == 0)) {
            Ellipse ellipse = shape instanceof Disc disc ? disc.toEllipse() : (Ellipse) shape;
            edgeWithEllipse(sector, sector.leftEdge(), ellipse, hits);
            edgeWithEllipse(sector, sector.rightEdge(), ellipse, hits);
            arcWithEllipse(sector, ellipse, hits);
        }
        return hits;
    }

    private static void edgeWithSegment(Sector sector, Vector2 edge, Segment segment, List<Vector2> hits) {
        Vector2 start = segment.a().minus(sector.apex());
        Vector2 along = segment.b().minus(segment.a());
        double across = edge.cross(along);
        if (across == 0) {
            return;
        }
        // The point is computed on the segment and then measured along the edge, so that it lies on both even if they
        // are nearly parallel.
        double fraction = start.cross(edge) / across;
        Vector2 point = segment.pointAt(fraction);
        double distance = point.minus(sector.apex()).dot(edge);
        if (fraction >= 0 && fraction <= 1 && distance >= 0 && distance <= sector.range()) {
            hits.add(point);
        }
    }

    private static void edgeWithEllipse(Sector sector, Vector2 edge, Ellipse ellipse, List<Vector2> hits) {
        Vector2 apex = ellipse.toUnitCircle(sector.apex());
        Vector2 step = ellipse.toUnitCircle(sector.apex().plus(edge)).minus(apex);
        double a = step.dot(step);
        double b = apex.dot(step);
        double aside = apex.cross(step);
        double root = Math.sqrt(a - aside * aside);
        for (double distance : new double[] {(-b - root) / a, (-b + root) / a}) {
            if (distance >= 0 && distance <= sector.range()) {
                hits.add(sector.apex().plus(edge.times(distance)));
            }
        }
    }

    private static void arcWithSegment(Sector sector, Segment segment, List<Vector2> hits) {
        Vector2 start = segment.a().minus(sector.apex());
        Vector2 along = segment.b().minus(segment.a());
        double a = along.dot(along);
        if (a == 0) {
            return;
        }
        double b = start.dot(along);
        double aside = start.cross(along);
        double root = Math.sqrt(a * sector.range() * sector.range() - aside * aside);
        for (double fraction : new double[] {(-b - root) / a, (-b + root) / a}) {
            Vector2 direction = start.plus(along.times(fraction));
            if (fraction >= 0 && fraction <= 1 && containsDirection(sector, direction)) {
                hits.add(sector.apex().plus(direction));
            }
        }
    }

    private static boolean containsDirection(Sector sector, Vector2 direction) {
        return direction.cross(sector.leftEdge()) >= 0 && sector.rightEdge().cross(direction) >= 0;
    }

    /**
     * With z = tan(angle / 2), the angle measured from the axis, a point of the arc is apex + range ((1 - z^2) axis + 2
     * z aside) / (1 + z^2), and the ellipse's equation becomes a quartic in z; |z| is below tan 45 degrees.
     */
    private static void arcWithEllipse(Sector sector, Ellipse ellipse, List<Vector2> hits) {
        Vector2 apex = ellipse.toUnitCircle(sector.apex());
        Vector2 axis = ellipse.toUnitCircle(sector.apex().plus(sector.axis().times(sector.range())))
                .minus(apex);
        Vector2 aside = ellipse.toUnitCircle(
                        sector.apex().plus(sector.axis().perpendicular().times(sector.range())))
                .minus(apex);
        double[] x = {apex.x() + axis.x(), 2 * aside.x(), apex.x() - axis.x()};
        double[] y = {apex.y() + axis.y(), 2 * aside.y(), apex.y() - axis.y()};
        double[] quartic = new double[5];
        double[] one = {1, 0, 1};
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                quartic[i + j] += x[i] * x[j] + y[i] * y[j] - one[i] * one[j];
            }
        }
        double limit = sector.sinHalf() / (1 + sector.cosHalf());
        for (double z : PolynomialRoots.between(quartic, -limit, limit)) {
            double d = 1 + z * z;
            Vector2 direction = sector.axis().rotated((1 - z * z) / d, 2 * z / d);
            hits.add(sector.apex().plus(direction.times(sector.range())));
        }
    }
}
