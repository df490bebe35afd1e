package faultline.geometry;

import java.util.ArrayList;
import java.util.List;

/**
 * Where a sector's outline (two edges and an arc) meets the outline of a figure: the intersection points that the paper
 * circles. They are for the eye only; no reading is taken from them.
 */
public final class SectorIntersections {

    private SectorIntersections() {}

    /**
     * The points where the outlines cross. Where they merely touch, or run along each other, points may be left out.
     *
     * @param sector the sector
     * @param figure the figure
     * @return left edge first, then right edge, then arc; empty where the outlines are apart
     */
    public static List<Vector2> points(Sector sector, ConvexShape figure) {
        List<Vector2> hits = new ArrayList<>();
        addEdgePoints(sector, sector.leftEdge(), figure, hits);
        addEdgePoints(sector, sector.rightEdge(), figure, hits);
        if (figure instanceof Segment segment) {
            arcWithSegment(sector, segment, hits);
        } else if (figure instanceof Disc disc) {
            arcWithEllipse(sector, new Ellipse(disc.cx(), disc.cy(), disc.radius(), disc.radius(), 1, 0), hits);
        } else {
            arcWithEllipse(sector, (Ellipse) figure, hits);
        }
        return hits;
    }

    private static void addEdgePoints(Sector sector, Vector2 edge, ConvexShape figure, List<Vector2> hits) {
        if (figure instanceof Segment segment) {
            edgeWithSegment(sector, edge, segment, hits);
        } else if (figure instanceof Disc disc) {
            edgeWithEllipse(sector, edge, new Ellipse(disc.cx(), disc.cy(), disc.radius(), disc.radius(), 1, 0), hits);
        } else {
            edgeWithEllipse(sector, edge, (Ellipse) figure, hits);
        }
    }

    private static void edgeWithSegment(Sector sector, Vector2 edge, Segment segment, List<Vector2> hits) {
        Vector2 start = segment.a().minus(sector.apex());
        Vector2 along = segment.b().minus(segment.a());
        double across = edge.cross(along);
        if (across == 0) {
            return;
        }
        // The point is taken along the segment and then measured along the edge, so that it lies on both even where
        // they are all but
        // parallel.
        double share = start.cross(edge) / across;
        Vector2 point = segment.pointAt(share);
        double distance = point.minus(sector.apex()).dot(edge);
        if (share >= 0 && share <= 1 && distance >= 0 && distance <= sector.range()) {
            hits.add(point);
        }
    }

    private static void edgeWithEllipse(Sector sector, Vector2 edge, Ellipse oval, List<Vector2> hits) {
        Vector2 apex = scaled(oval, oval.toLocal(sector.apex()));
        Vector2 step = scaled(oval, oval.toLocal(sector.apex().plus(edge))).minus(apex);
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

    private static Vector2 scaled(Ellipse oval, Vector2 local) {
        return new Vector2(local.x() / oval.rx(), local.y() / oval.ry());
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
        for (double share : new double[] {(-b - root) / a, (-b + root) / a}) {
            Vector2 direction = start.plus(along.times(share));
            if (share >= 0 && share <= 1 && containsDirection(sector, direction)) {
                hits.add(sector.apex().plus(direction));
            }
        }
    }

    private static boolean containsDirection(Sector sector, Vector2 direction) {
        return direction.cross(sector.leftEdge()) >= 0 && sector.rightEdge().cross(direction) >= 0;
    }

    /**
     * With z = tan(angle / 2), where the angle is from the axis, the arc's point is apex + range ((1 - z^2) axis + 2 z
     * aside) / (1 + z^2), and the ellipse's equation becomes a quartic in z; |z| stays below tan 45 degrees.
     */
    private static void arcWithEllipse(Sector sector, Ellipse oval, List<Vector2> hits) {
        Vector2 apex = scaled(oval, oval.toLocal(sector.apex()));
        Vector2 axis = scaled(
                        oval, oval.toLocal(sector.apex().plus(sector.axis().times(sector.range()))))
                .minus(apex);
        Vector2 aside = scaled(
                        oval,
                        oval.toLocal(
                                sector.apex().plus(sector.axis().perpendicular().times(sector.range()))))
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
