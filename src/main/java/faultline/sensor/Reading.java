package faultline.sensor;

import java.util.OptionalDouble;

/**
 * What a sensor gives at one moment: a distance, nothing within range, or no answer because it is off. In arrays a
 * reading is one {@code double}: the distance in metres, {@link #NOTHING} or {@link #OFF}.
 *
 * @param encoded the distance in metres, not negative, or {@link #NOTHING}, or {@link #OFF}
 */
public record Reading(double encoded) {

    /** The code for nothing within range: positive infinity. */
    public static final double NOTHING = Double.POSITIVE_INFINITY;

    /** The code for a sensor that is off: not a number; ask {@link #isOff(double)}, not {@code ==}. */
    public static final double OFF = Double.NaN;

    /**
     * Whether a code stands for a sensor that is off.
     *
     * @param code an encoded reading
     * @return true for {@link #OFF}
     */
    public static boolean isOff(double code) {
        return code != code;
    }

    /**
     * Whether the sensor is off.
     *
     * @return true where there is no answer at all
     */
    public boolean isOff() {
        return isOff(encoded);
    }

    /**
     * The distance.
     *
     * @return metres, empty where nothing is within range or the sensor is off
     */
    public OptionalDouble distance() {
        return Double.isFinite(encoded) ? OptionalDouble.of(encoded) : OptionalDouble.empty();
    }
}
