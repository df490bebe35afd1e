package faultline.geometry;

/**
 * A point or a displacement in the plane, with x to the right and y up.
 *
 * @param x metres
 * @param y metres
 */
public record Vector2(double x, double y) {

    /** The origin, or no displacement. */
    public static final Vector2 ZERO = new Vector2(0, 0);

    /**
     * {@return the unit vector at an angle, radians counter-clockwise from the x axis}
     *
     * @param angle the angle, in radians
     */
    public static Vector2 direction(double angle) {
        return new Vector2(StrictTrig.cos(angle), StrictTrig.sin(angle));
    }

    /**
     * {@return the sum of this vector and another}
     *
     * @param other the vector to add
     */
    public Vector2 plus(Vector2 other) {
        return new Vector2(x + other.x, y + other.y);
    }

    /**
     * {@return the difference of this vector and another}
     *
     * @param other the vector to subtract
     */
    public Vector2 minus(Vector2 other) {
        return new Vector2(x - other.x, y - other.y);
    }

    /**
     * {@return this vector multiplied by a factor}
     *
     * @param factor the factor
     */
    public Vector2 times(double factor) {
        return new Vector2(factor * x, factor * y);
    }

    /**
     * {@return the dot product with another vector}
     *
     * @param other the other vector
     */
    public double dot(Vector2 other) {
        return x * other.x + y * other.y;
    }

    /**
     * {@return the z component of the cross product, positive if {@code other} is counter-clockwise of this vector}
     *
     * @param other the other vector
     */
    public double cross(Vector2 other) {
        return x * other.y - y * other.x;
    }

    /** {@return the length, metres, not negative} */
    public double length() {
        return Math.sqrt(x * x + y * y);
    }

    /**
     * {@return the distance to a point, metres, not negative}
     *
     * @param other the point, in metres
     */
    public double distanceTo(Vector2 other) {
        double dx = other.x - x;
        double dy = other.y - y;
        return Math.sqrt(dx * dx + dy * dy);
    }

    /**
     * {@return the angle of this vector in [-pi, pi], counter-clockwise from the x axis; for the zero vector, that of
     * {@link StrictMath#atan2}, which depends on the signs of the zeros}
     */
    public double angle() {
        return StrictMath.atan2(y, x);
    }

    /** {@return this vector rotated by a quarter turn to the left, (-y, x)} */
    public Vector2 perpendicular() {
        return new Vector2(-y, x);
    }

    /**
     * {@return this vector rotated by an angle with a known cosine and sine}
     *
     * @param cos the cosine of the angle
     * @param sin the sine of the angle, positive to the left
     */
    public Vector2 rotated(double cos, double sin) {
        return new Vector2(cos * x - sin * y, sin * x + cos * y);
    }

    /** {@return whether both components are finite} */
    public boolean isFinite() {
        return Double.isFinite(x) && Double.isFinite(y);
    }
}
