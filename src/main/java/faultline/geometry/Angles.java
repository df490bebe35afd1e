package faultline.geometry;

/** Normalises angles in radians to one turn. */
public final class Angles {

    private static final double TWO_PI = 2 * StrictMath.PI;

    // A turn in a part of 33 bits and the rest, so that products with fewer turns than MAX_TURNS are exact.
    private static final double TWO_PI_HIGH =
            Double.longBitsToDouble(Double.doubleToRawLongBits(TWO_PI) & 0xFFFF_FFFF_FFF0_0000L);
    private static final double TWO_PI_LOW = TWO_PI - TWO_PI_HIGH;
    private static final double MAX_TURNS = 1 << 20;

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
        double rest = remainder(angle);
        return rest <= -StrictMath.PI ? rest + TWO_PI : rest;
    }

    /** Returns {@link StrictMath#IEEEremainder}, in most cases without its native call. */
    private static double remainder(double angle) {
        double turns = Math.rint(angle / TWO_PI);
        // Both differences are exact: multiples of the angle's last bit, and less than four.
        double rest = angle - turns * TWO_PI_HIGH - turns * TWO_PI_LOW;
        boolean certain = Math.abs(turns) < MAX_TURNS && Math.abs(rest) < StrictMath.PI && rest != 0;
        return certain ? rest : StrictMath.IEEEremainder(angle, TWO_PI);
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
