package faultline.geometry;

/** Normalises angles in radians to one turn. */
public final class Angles {

    private static final double TWO_PI = 2 * StrictMath.PI;

    private Angles() {}

    /**
     * {@return the equivalent of a finite angle in (-pi, pi], radians}
     *
     * @param angle the angle, in radians, finite
     */
    public static double normalize(double angle) {
        if (angle > -StrictMath.PI && angle <= StrictMath.PI) {
            return angle;
        }
        double rest = StrictMath.IEEEremainder(angle, TWO_PI);
        return rest <= -StrictMath.PI ? rest + TWO_PI : rest;
    }

    /**
     * {@return the smallest turn from one direction to another in (-pi, pi], radians, positive counter-clockwise}
     *
     * @param from the first direction, in radians
     * @param to the second direction, in radians
     */
    public static double difference(double from, double to) {
        return normalize(to - from);
    }
}
