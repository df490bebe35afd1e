package faultline.geometry;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * The reading of a cone sensor from a specular flat surface, and its intersection points. Such a surface reflects light
 * back only where the angle of incidence, measured from its normal, is at most some limit: on the part of the segment
 * about the foot of the apex.
 */
public final class SpecularDistance {

    private SpecularDistance() {}

    /**
     * {@return the distance to the nearest point of a segment within a sector that reflects light back, metres in [0,
     * range]; positive infinity if there is none}
     *
     * @param sector the sector
     * @param segment the surface
     * @param tangent the tangent of the greatest angle of incidence that reflects light back, positive
     */
    public static double nearest(SectorDistance sector, Segment segment, double tangent) {
        Part part = reflectingPart(sector.x(), sector.y(), segment, tangent);
        if (part.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        double dx = segment.bx() - segment.ax();
        double dy = segment.by() - segment.ay();
        double ax = part.from == 1 ? segment.bx() : segment.ax() + part.from * dx;
        double ay = part.from == 1 ? segment.by() : segment.ay() + part.from * dy;
        double bx = part.to == 1 ? segment.bx() : segment.ax() + part.to * dx;
        double by = part.to == 1 ? segment.by() : segment.ay() + part.to * dy;
        return sector.toSegment(ax, ay, bx - ax, by - ay);
    }

    /**
     * {@return the points where a sector's outline meets the reflecting part of a segment, and the ends of that part
     * that lie inside the sector} They are only drawn, like {@link SectorIntersections#points}. Empty if nothing is
     * reflected, or if the whole surface lies inside the sector and reflects.
     *
     * @param sector the sector
     * @param segment the surface
     * @param incidence the greatest angle of incidence that reflects light back, radians in (0, pi / 2)
     */
    public static List<Vector2> intersections(Sector sector, Segment segment, double incidence) {
        Part reflecting = reflectingPart(sector.apex().x(), sector.apex().y(), segment, StrictMath.tan(incidence));
        if (reflecting.isEmpty()) {
            return List.of();
        }
        Segment part = new Segment(segment.pointAt(reflecting.from), segment.pointAt(reflecting.to));
        List<Vector2> hits = new ArrayList<>(SectorIntersections.points(sector, part));
        Stream.of(part.a(), part.b())
                .filter(end -> !end.equals(segment.a()) && !end.equals(segment.b()))
                .filter(end -> SectorDistance.nearest(sector, new Segment(end, end)) <= sector.range())
                .forEach(hits::add);
        return hits;
    }

    /** The part of a segment between two fractions of it; empty if they are in the wrong order. */
    private record Part(double from, double to) {

        boolean isEmpty() {
            return from > to;
        }
    }

    private static Part reflectingPart(double apexX, double apexY, Segment segment, double tangent) {
        double dx = segment.bx() - segment.ax();
        double dy = segment.by() - segment.ay();
        double length = Math.sqrt(dx * dx + dy * dy);
        double alongX = 1 / length * dx;
        double alongY = 1 / length * dy;
        double toApexX = apexX - segment.ax();
        double toApexY = apexY - segment.ay();
        double foot = alongX * toApexX + alongY * toApexY;
        double half = Math.abs(alongX * toApexY - alongY * toApexX) * tangent;
        // One expression creates it, so that the compiler can replace it by two local variables.
        return new Part(
                length == 0 ? 0 : Math.max(0, foot - half) / length,
                length == 0 ? 1 : Math.min(length, foot + half) / length);
    }
}
