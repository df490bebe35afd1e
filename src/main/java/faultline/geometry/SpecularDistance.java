package faultline.geometry;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * What a cone sensor reads of a glossy flat surface, and what is circled there: its light comes back only from where it
 * meets the surface at no more than some angle of incidence, measured from the surface's normal. Those points are the
 * segment's stretch about the foot of the apex.
 */
public final class SpecularDistance {

    private SpecularDistance() {}

    /**
     * The distance to the nearest point of a segment within a sector that sends light back.
     *
     * @param sector the sector
     * @param segment the surface
     * @param incidence the greatest angle of incidence that it sends light back from, radians in (0, pi / 2)
     * @return metres in [0, range], or positive infinity where no such point lies in the sector
     */
    public static double nearest(Sector sector, Segment segment, double incidence) {
        return reflectingPart(sector.apex(), segment, incidence)
                .map(stretch -> SectorDistance.nearest(sector, stretch))
                .orElse(Double.POSITIVE_INFINITY);
    }

    /**
     * The points where a sector's outline meets the part of a segment that sends light back, and where that part ends
     * inside the sector because the light comes in too flat beyond. Like {@link SectorIntersections#points} for the eye
     * only.
     *
     * @param sector the sector
     * @param segment the surface
     * @param incidence the greatest angle of incidence that it sends light back from, radians in (0, pi / 2)
     * @return empty where nothing comes back, or where the whole of the surface lies inside the sector and answers
     */
    public static List<Vector2> intersections(Sector sector, Segment segment, double incidence) {
        List<Vector2> hits = new ArrayList<>();
        reflectingPart(sector.apex(), segment, incidence).ifPresent(stretch -> {
            hits.addAll(SectorIntersections.points(sector, stretch));
            Stream.of(stretch.a(), stretch.b())
                    .filter(end -> !end.equals(segment.a()) && !end.equals(segment.b()))
                    .filter(end -> SectorDistance.nearest(sector, new Segment(end, end)) <= sector.range())
                    .forEach(hits::add);
        });
        return hits;
    }

    /** The stretch that sends light back to an apex. */
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
