package faultline.geometry;

/**
 * The distance between a box and a shape, with a pair of points at that distance.
 *
 * @param distance metres, 0 if they touch or overlap
 * @param onBox the point of the box, in the world
 * @param onShape the point of the shape, in the world
 */
public record Separation(double distance, Vector2 onBox, Vector2 onShape) {

    /** Returns the smaller of two separations; the first if they are equal. */
    static Separation min(Separation one, Separation other) {
        return other.distance < one.distance ? other : one;
    }
}
