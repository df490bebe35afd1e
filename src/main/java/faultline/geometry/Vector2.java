package faultline.geometry;

/**
 * A point or a displacement in the plane; x to the right, y up.
 *
 * @param x metres
 * @param y metres
 */
public record Vector2(double x, double y) {

    /** The origin, or no displacement. */
    public static final Vector2 ZERO = new Vector2(0, 0);

    /**
     * The unit vector at an angle.
     *
     * @param angle radians, counter-clockwise from the x axis
     * @return (cos angle, sin angle)
     */
    public static Vector2 direction(double angle) {
        return new Vector2(StrictMath.cos(angle), StrictMath.sin(angle));
    }

    /**
     * The sum of two vectors.
     *
     * @param other the other vector
     * @return this + other
     */
    public Vector2 plus(Vector2 other) {
        return new Vector2(x + other.x, y + other.y);
    }

    /**
     * The difference of two vectors.
     *
     * @param other the other vector
     * @return this - other
     */
    public Vector2 minus(Vector2 other) {
        return new Vector2(x - other.x, y - other.y);
    }

    /**
     * This vector scaled.
     *
     * @param factor any finite number
     * @return factor * this
     */
    public Vector2 times(double factor) {
        return new Vector2(factor * x, factor * y);
    }

    /**
     * The dot product.
     *
     * @param other the other vector
     * @return this . other
     */
    public double dot(Vector2 other) {
        return x * other.x + y * other.y;
    }

    /**
     * The cross product's z component.
     *
     * @param other the other vector
     * @return positive where {@code other} lies counter-clockwise of this
     */
    public double cross(Vector2 other) {
        return x * other.y - y * other.x;
    }

    /**
     * The length of this vector.
     *
     * @return metres, not negative
     */
    public double length() {
        return Math.sqrt(x * x + y * y);
    }

    /**
     * The distance to a point.
     *
     * @param other the other point
     * @return metres, not negative
     */
    public double distanceTo(Vector2 other) {
        double dx = other.x - x;
        double dy = other.y - y;
        return Math.sqrt(dx * dx + dy * dy);
    }

    /**
     * The bearing of this vector.
     *
     * @return radians in [-pi, pi], counter-clockwise from the x axis; 0 for the zero vector
     */
    public double angle() {
        return StrictMath.atan2(y, x);
    }

    /**
     * This vector a quarter turn to the left.
     *
     * @return (-y, x)
     */
    public Vector2 perpendicular() {
        return new Vector2(-y, x);
    }

    /**
     * This vector turned by an angle whose cosine and sine are known.
     *
     * @param cos the cosine
     * @param sin the sine
     * @return the turned vector
     */
    public Vector2 rotated(double cos, double sin) {
        return new Vector2(cos * x - sin * y, sin * x + cos * y);
    }

    /**
     * Whether both components are finite.
     *
     * @return false for an infinite component or one that is not a number
     */
    public boolean isFinite() {
        return Double.isFinite(x) && Double.isFinite(y);
    }
}
