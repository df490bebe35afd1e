package faultline.geometry;

/**
 * A circular sector narrower than a half turn: the part of the plane that a cone sensor sees. Its edges and its arc
 * belong to it. The angles are kept as unit vectors, so that carrying a sector with a robot needs one sine and cosine
 * however many sensors there are.
 *
 * @param ax the apex's x, metres
 * @param ay the apex's y, metres
 * @param ux the axis, a unit vector's x
 * @param uy the axis, a unit vector's y
 * @param cosHalf the cosine of half the full angle, in (0, 1]
 * @param sinHalf the sine of half the full angle, in [0, 1)
 * @param range the radius, metres, positive
 */
public record Sector(double ax, double ay, double ux, double uy, double cosHalf, double sinHalf, double range) {

    /**
     * The sector about an axis.
     *
     * @param apex the apex
     * @param bearing of the axis, radians
     * @param angle the full angle, radians in (0, pi)
     * @param range the radius, metres, positive
     * @return the sector
     */
    public static Sector of(Vector2 apex, double bearing, double angle, double range) {
        if (!(angle > 0 && angle < StrictMath.PI && range > 0)) {
            throw new IllegalArgumentException(
                    "a sector needs an angle in (0, pi) and a positive range: " + angle + ", " + range);
        }
        Vector2 axis = Vector2.direction(bearing);
        return new Sector(
                apex.x(), apex.y(), axis.x(), axis.y(), StrictMath.cos(angle / 2), StrictMath.sin(angle / 2), range);
    }

    /**
     * The apex.
     *
     * @return metres
     */
    public Vector2 apex() {
        return new Vector2(ax, ay);
    }

    /**
     * The axis.
     *
     * @return a unit vector
     */
    public Vector2 axis() {
        return new Vector2(ux, uy);
    }

    /**
     * The edge on the left of the axis, seen from the apex.
     *
     * @return a unit vector
     */
    public Vector2 leftEdge() {
        return axis().rotated(cosHalf, sinHalf);
    }

    /**
     * The edge on the right of the axis, seen from the apex.
     *
     * @return a unit vector
     */
    public Vector2 rightEdge() {
        return axis().rotated(cosHalf, -sinHalf);
    }
}
