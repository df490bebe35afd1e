package faultline.geometry;

/**
 * A point or a displacement in the plane; x to the right, y up.
 *
 * @param x metres
 * @param y metres
 */
public record Vec(double x, double y) {

    /** The origin, or no displacement. */
    public static final Vec ZERO = new Vec(0, 0);

    /**
     * The unit vector at an angle.
     *
     * @param angle radians, counter-clockwise from the x axis
     * @return (cos angle, sin angle)
     */
    public static Vec direction(double angle) {
        return new Vec(StrictMath.cos(angle), StrictMath.sin(angle));
    }

    /**
     * The sum of two vectors.
     *
     * @param other the other vector
     * @return this + other
     */
    public Vec plus(Vec other) {
        return new Vec(x + other.x, y + other.y);
    }

    /**
     * The difference of two vectors.
     *
     * @param other the other vector
     * @return this - other
     */
    public Vec minus(Vec other) {
        return new Vec(x - other.x, y - other.y);
    }

    /**
     * This vector scaled.
     *
     * @param factor any finite number
     * @return factor * this
     */
    public Vec times(double factor) {
        return new Vec(factor * x, factor * y);
    }

    /**
     * The dot product.
     *
     * @param other the other vector
     * @return this . other
     */
    public double dot(Vec other) {
        return x * other.x + y * other.y;
    }

    /**
     * The cross product's z component.
     *
     * @param other the other vector
     * @return positive where {@code other} lies counter-clockwise of this
     */
    public double cross(Vec other) {
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
    public double distanceTo(Vec other) {
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
    public Vec perpendicular() {
        return new Vec(-y, x);
    }

    /**
     * This vector turned by an angle whose cosine and sine are known.
     *
     * @param cos the cosine
     * @param sin the sine
     * @return the turned vector
     */
    public Vec turned(double cos, double sin) {
        return new Vec(cos * x - sin * y, sin * x + cos * y);
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
