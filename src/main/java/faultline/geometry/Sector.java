package faultline.geometry;

/**
 * A circular sector narrower than a half turn: the area that a cone sensor senses. Its edges and its arc belong to it.
 * Angles are kept as unit vectors, so that moving all sectors with a robot needs one sine and cosine.
 *
 * @param frame the frame of the sector: the apex is its origin, and its x axis is the sector's axis
 * @param cosHalf the cosine of half the full angle, in (0, 1]
 * @param sinHalf the sine of half the full angle, in [0, 1)
 * @param range the radius, metres, positive
 */
public record Sector(RigidMotion frame, double cosHalf, double sinHalf, double range) {

    /**
     * Creates a sector.
     *
     * @param frame the frame of the sector: the apex is its origin, and its x axis is the sector's axis
     * @param cosHalf the cosine of half the full angle, in (0, 1]
     * @param sinHalf the sine of half the full angle, in [0, 1)
     * @param range the radius, metres, positive
     * @throws IllegalArgumentException if the motion's rotation, the half angle or the range is outside its limits
     */
    public Sector {
        RigidMotion.requireUnit(cosHalf, sinHalf);
        if (!(cosHalf > 0 && sinHalf >= 0 && range > 0 && Double.isFinite(range))) {
            throw new IllegalArgumentException(
                    "a sector needs half an angle in [0, pi / 2) and a positive range: cosine " + cosHalf + ", sine "
                            + sinHalf + ", range " + range);
        }
    }

    /**
     * {@return the sector about an axis}
     *
     * @param apex the apex
     * @param bearing the direction of the axis, radians
     * @param angle the full angle, radians in (0, pi)
     * @param range the radius, metres, positive
     * @throws IllegalArgumentException if the angle or the range is outside its limits, or a number is not finite
     */
    public static Sector of(Vector2 apex, double bearing, double angle, double range) {
        if (!(angle > 0 && angle < StrictMath.PI)) {
            throw new IllegalArgumentException("a sector needs an angle in (0, pi): " + angle);
        }
        return new Sector(
                RigidMotion.of(new Pose(apex.x(), apex.y(), bearing)),
                StrictMath.cos(angle / 2),
                StrictMath.sin(angle / 2),
                range);
    }

    /** {@return the apex} */
    public Vector2 apex() {
        return frame.position();
    }

    /** {@return the axis, a unit vector} */
    public Vector2 axis() {
        return frame.axis();
    }

    /** {@return the direction of the edge to the left of the axis, a unit vector} */
    public Vector2 leftEdge() {
        return axis().rotated(cosHalf, sinHalf);
    }

    /** {@return the direction of the edge to the right of the axis, a unit vector} */
    public Vector2 rightEdge() {
        return axis().rotated(cosHalf, -sinHalf);
    }
}
