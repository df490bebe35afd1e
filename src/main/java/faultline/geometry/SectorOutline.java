package faultline.geometry;

import java.util.ArrayList;
import java.util.List;

/**
 * Where a sector's outline (two edges and an arc) meets the outline of a figure: the intersection points that the paper circles. They are
 * for the eye only; no reading is taken from them.
 */
public final class SectorOutline {

    private SectorOutline() {
    }

    /**
     * The points where the outlines cross. Where they merely touch, or run along each other, points may be left out.
     *
     * @param sector the sector
     * @param figure the figure
     * @return left edge first, then right edge, then arc; empty where the outlines are apart
     */
    public static List<Vec> hits(Sector sector, Convex figure) {
        List<Vec> hits = new ArrayList<>();
        alongEdge(sector, sector.leftEdge(), figure, hits);
        alongEdge(sector, sector.rightEdge(), figure, hits);
        if (figure instanceof Segment segment) {
            arcWithSegment(sector, segment, hits);
        } else if (figure instanceof Disc disc) {
            arcWithOval(sector, new Oval(disc.cx(), disc.cy(), disc.radius(), disc.radius(), 1, 0), hits);
        } else {
            arcWithOval(sector, (Oval) figure, hits);
        }
        return hits;
    }

    private static void alongEdge(Sector sector, Vec edge, Convex figure, List<Vec> hits) {
        if (figure instanceof Segment segment) {
            edgeWithSegment(sector, edge, segment, hits);
        } else if (figure instanceof Disc disc) {
            edgeWithOval(sector, edge, new Oval(disc.cx(), disc.cy(), disc.radius(), disc.radius(), 1, 0), hits);
        } else {
            edgeWithOval(sector, edge, (Oval) figure, hits);
        }
    }

    private static void edgeWithSegment(Sector sector, Vec edge, Segment segment, List<Vec> hits) {
        Vec start = segment.a().minus(sector.apex());
        Vec along = segment.b().minus(segment.a());
        double across = edge.cross(along);
        if (across == 0) {
            return;
        }
        // The point is taken along the segment and then measured along the edge, so that it lies on both even where they are all but
        // parallel.
        double share = start.cross(edge) / across;
        Vec point = segment.at(share);
        double distance = point.minus(sector.apex()).dot(edge);
        if (share >= 0 && share <= 1 && distance >= 0 && distance <= sector.range()) {
            hits.add(point);
        }
    }

    private static void edgeWithOval(Sector sector, Vec edge, Oval oval, List<Vec> hits) {
        Vec apex = scaled(oval, oval.toLocal(sector.apex()));
        Vec step = scaled(oval, oval.toLocal(sector.apex().plus(edge))).minus(apex);
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

    private static Vec scaled(Oval oval, Vec local) {
        return new Vec(local.x() / oval.rx(), local.y() / oval.ry());
    }

    private static void arcWithSegment(Sector sector, Segment segment, List<Vec> hits) {
        Vec start = segment.a().minus(sector.apex());
        Vec along = segment.b().minus(segment.a());
        double a = along.dot(along);
        if (a == 0) {
            return;
        }
        double b = start.dot(along);
        double aside = start.cross(along);
        double root = Math.sqrt(a * sector.range() * sector.range() - aside * aside);
        for (double share : new double[] {(-b - root) / a, (-b + root) / a}) {
            Vec direction = start.plus(along.times(share));
            if (share >= 0 && share <= 1 && within(sector, direction)) {
                hits.add(sector.apex().plus(direction));
            }
        }
    }

    private static boolean within(Sector sector, Vec direction) {
        return direction.cross(sector.leftEdge()) >= 0 && sector.rightEdge().cross(direction) >= 0;
    }

    /**
     * With z = tan(angle / 2), where the angle is from the axis, the arc's point is apex + range ((1 - z^2) axis + 2 z aside) / (1 + z^2),
     * and the ellipse's equation becomes a quartic in z; |z| stays below tan 45 degrees.
     */
    private static void arcWithOval(Sector sector, Oval oval, List<Vec> hits) {
        Vec apex = scaled(oval, oval.toLocal(sector.apex()));
        Vec axis = scaled(oval, oval.toLocal(sector.apex().plus(sector.axis().times(sector.range())))).minus(apex);
        Vec aside = scaled(oval, oval.toLocal(sector.apex().plus(sector.axis().perpendicular().times(sector.range())))).minus(apex);
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
            Vec direction = sector.axis().turned((1 - z * z) / d, 2 * z / d);
            hits.add(sector.apex().plus(direction.times(sector.range())));
        }
    }
}
