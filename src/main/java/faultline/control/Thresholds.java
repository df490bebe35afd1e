package faultline.control;

import java.util.Arrays;

/** The values of all thresholds of a wall follower, each in the unit of its quantity. Immutable. */
public final class Thresholds {

    private static final Threshold[] ALL = Threshold.values();

    /** The default value of every threshold. */
    public static final Thresholds DEFAULT = new Thresholds(
            Arrays.stream(ALL).mapToDouble(Threshold::defaultValue).toArray());

    private final double[] values;

    private Thresholds(double[] values) {
        this.values = values;
    }

    /**
     * {@return the value of a threshold, in the unit of its quantity}
     *
     * @param threshold the threshold
     */
    public double get(Threshold threshold) {
        return values[threshold.ordinal()];
    }

    /**
     * {@return the value of an angle or a turn rate in radians or radians per second}
     *
     * @param threshold the threshold
     */
    public double radians(Threshold threshold) {
        return StrictMath.toRadians(get(threshold));
    }

    /**
     * {@return the same values but one}
     *
     * @param threshold the threshold that changes
     * @param value its new value, in the unit of its quantity
     * @throws IllegalArgumentException if the value is not within the bounds of its quantity
     */
    public Thresholds with(Threshold threshold, double value) {
        Threshold.Quantity quantity = threshold.quantity();
        if (!(value >= quantity.min() && value <= quantity.max())) {
            throw new IllegalArgumentException(
                    threshold.fileName() + " must be from " + quantity.min() + " to " + quantity.max() + ": " + value);
        }
        double[] changed = values.clone();
        changed[threshold.ordinal()] = value;
        return new Thresholds(changed);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Thresholds thresholds && Arrays.equals(values, thresholds.values);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(values);
    }

    @Override
    public String toString() {
        return Arrays.toString(values);
    }
}
