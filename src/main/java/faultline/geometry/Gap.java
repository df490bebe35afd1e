package faultline.geometry;

/**
 * The distance between a box and a figure, and a pair of points at that distance.
 *
 * @param distance metres, 0 where they touch or overlap
 * @param onBox the point of the box, in the world
 * @param onFigure the point of the figure, in the world
 */
public record Gap(double distance, Vec onBox, Vec onFigure) {

    /** The smaller of two gaps. */
    static Gap smaller(Gap one, Gap other) {
        return other.distance < one.distance ? other : one;
    }
}
