package faultline.sensor;

import java.util.OptionalDouble;

/**
 * The output of a sensor in one tick: a distance, nothing within range, or no answer because it is off. In arrays a
 * reading is encoded as one {@code double}: the distance in metres, {@link #NOTHING} or {@link #OFF}.
 *
 * @param encoded the distance in metres, not negative, or {@link #NOTHING}, or {@link #OFF}
 */
public record Reading(double encoded) {

    /** Encodes nothing within range: positive infinity. */
    public static final double NOTHING = Double.POSITIVE_INFINITY;

    /** Encodes a sensor that is off: not a number. Test with {@link #isOff(double)}, because {@code ==} is false. */
    public static final double OFF = Double.NaN;

    /**
     * Creates a reading.
     *
     * @param encoded the distance in metres, not negative, or {@link #NOTHING}, or {@link #OFF}
     * @throws IllegalArgumentException if the encoded value is negative
     */
    public Reading {
        if (encoded < 0) {
            throw new IllegalArgumentException("a reading must not be negative: " + encoded);
        }
    }

    /**
     * {@return the encoded reading of a measured distance: not less than 0, and {@link #NOTHING} beyond the range}
     *
     * @param distance the measured distance, metres; infinite for nothing
     * @param range the range of the sensor, metres
     */
    public static double encode(double distance, double range) {
        double reading = Math.max(0, distance);
        return reading <= range ? reading : NOTHING;
    }

    /**
     * {@return whether an encoded reading is {@link #OFF}}
     *
     * @param encoded the encoded reading
     */
    public static boolean isOff(double encoded) {
        return Double.isNaN(encoded);
    }

    /** {@return whether the sensor is off} */
    public boolean isOff() {
        return isOff(encoded);
    }

    /** {@return the distance, metres; empty if nothing is within range or the sensor is off} */
    public OptionalDouble distance() {
        return Double.isFinite(encoded) ? OptionalDouble.of(encoded) : OptionalDouble.empty();
    }
}
