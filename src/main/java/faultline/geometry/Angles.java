package faultline.geometry;

/** Angles in radians, brought into one turn. */
public final class Angles {

    private static final double TWO_PI = 2 * StrictMath.PI;

    private Angles() {}

    /**
     * The same direction in one turn.
     *
     * @param angle radians, finite
     * @return radians in (-pi, pi]
     */
    public static double normalize(double angle) {
        if (angle > -StrictMath.PI && angle <= StrictMath.PI) {
            return angle;
        }
        double rest = StrictMath.IEEEremainder(angle, TWO_PI);
        return rest <= -StrictMath.PI ? rest + TWO_PI : rest;
    }

    /**
     * The shortest turn from one direction to another.
     *
     * @param from radians
     * @param to radians
     * @return radians in (-pi, pi], positive counter-clockwise
     */
    public static double difference(double from, double to) {
        return normalize(to - from);
    }
}
