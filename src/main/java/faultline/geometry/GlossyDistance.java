package faultline.geometry;

/**
 * What a cone sensor reads of a glossy flat surface: its light comes back only from where it meets the surface at no more than some angle of incidence, measured from
 * the surface's normal. Those points are the segment's stretch about the foot of the apex.
 */
public final class GlossyDistance {

    private GlossyDistance() {
    }

    /**
     * The distance to the nearest point of a segment within a sector that sends light back.
     *
     * @param sector the sector
     * @param segment the surface
     * @param incidence the greatest angle of incidence that it sends light back from, radians in (0, pi / 2)
     * @return metres in [0, range], or positive infinity where no such point lies in the sector
     */
    public static double nearest(Sector sector, Segment segment, double incidence) {
        double length = segment.length();
        if (length == 0) {
            return SectorDistance.nearest(sector, segment);
        }
        Vec along = segment.b().minus(segment.a()).times(1 / length);
        Vec toApex = sector.apex().minus(segment.a());
        double foot = along.dot(toApex);
        double half = Math.abs(along.cross(toApex)) * StrictMath.tan(incidence);
        double from = Math.max(0, foot - half);
        double to = Math.min(length, foot + half);
        if (from > to) {
            return Double.POSITIVE_INFINITY;
        }
        return SectorDistance.nearest(sector, new Segment(segment.at(from / length), segment.at(to / length)));
    }
}
