package faultline.geometry;

/**
 * The distance between a box and a figure, and a pair of points at that distance.
 *
 * @param distance metres, 0 where they touch or overlap
 * @param onBox the point of the box, in the world
 * @param onShape the point of the figure, in the world
 */
public record Separation(double distance, Vector2 onBox, Vector2 onShape) {

    /** The smaller of two gaps. */
    static Separation min(Separation one, Separation other) {
        return other.distance < one.distance ? other : one;
    }
}
