package faultline.geometry;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
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
        double dx = segment.bx() - segment.ax();
        double dy = segment.by() - segment.ay();
        double length = Math.sqrt(dx * dx + dy * dy);
        if (length == 0) {
            return sector.nearest(segment);
        }
        double alongX = 1 / length * dx;
        double alongY = 1 / length * dy;
        double toApexX = sector.x() - segment.ax();
        double toApexY = sector.y() - segment.ay();
        double foot = alongX * toApexX + alongY * toApexY;
        double half = Math.abs(alongX * toApexY - alongY * toApexX) * tangent;
        double from = Math.max(0, foot - half) / length;
        double to = Math.min(length, foot + half) / length;
        if (from > to) {
            return Double.POSITIVE_INFINITY;
        }
        double ax = from == 1 ? segment.bx() : segment.ax() + from * dx;
        double ay = from == 1 ? segment.by() : segment.ay() + from * dy;
        double bx = to == 1 ? segment.bx() : segment.ax() + to * dx;
        double by = to == 1 ? segment.by() : segment.ay() + to * dy;
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
        List<Vector2> hits = new ArrayList<>();
        reflectingPart(sector.apex(), segment, incidence).ifPresent(part -> {
            hits.addAll(SectorIntersections.points(sector, part));
            Stream.of(part.a(), part.b())
                    .filter(end -> !end.equals(segment.a()) && !end.equals(segment.b()))
                    .filter(end -> SectorDistance.nearest(sector, new Segment(end, end)) <= sector.range())
                    .forEach(hits::add);
        });
        return hits;
    }

    private static Optional<Segment> reflectingPart(Vector2 apex, Segment segment, double incidence) {
        double length = segment.length();
        if (length == 0) {
            return Optional.of(segment);
        }
        Vector2 along = segment.b().minus(segment.a()).times(1 / length);
        Vector2 toApex = apex.minus(segment.a());
        double foot = along.dot(toApex);
        double half = Math.abs(along.cross(toApex)) * StrictMath.tan(incidence);
        double from = Math.max(0, foot - half);
        double to = Math.min(length, foot + half);
        return from > to
                ? Optional.empty()
                : Optional.of(new Segment(segment.pointAt(from / length), segment.pointAt(to / length)));
    }
}
