package faultline.sensor;

/**
 * The limits of sensor settings. {@link SensorSpec} checks them, and the scenario format uses them. The controls of the
 * window stay within them.
 */
public final class SensorLimits {

    /** The shortest range, metres. */
    public static final double MIN_RANGE = 1e-6;

    /** The longest range, metres. */
    public static final double MAX_RANGE = 100_000;

    /** The cone's full angle is greater than 0 and less than this, radians. */
    public static final double MAX_CONE = StrictMath.PI;

    /** The greatest standard deviation of the noise, metres. */
    public static final double MAX_NOISE = 100;

    private SensorLimits() {}
}
