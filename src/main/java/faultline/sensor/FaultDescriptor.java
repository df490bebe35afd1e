package faultline.sensor;

import java.util.Locale;

/**
 * The properties of a kind of fault for files and windows: its name, its number, and the creation of its faults.
 *
 * @param <F> the type of the faults
 */
public interface FaultDescriptor<F> {

    /**
     * The number of a kind of fault.
     *
     * @param unit its unit, empty for a number without one
     * @param min the smallest number allowed
     * @param max the greatest number allowed, equal to the smallest one for kinds without a number
     * @param initial the number to use if none is given
     */
    record Parameter(String unit, double min, double max, double initial) {}

    /** {@return the name of the constant} */
    String name();

    /** {@return the number of faults of this kind} */
    Parameter parameter();

    /**
     * {@return a fault of this kind}
     *
     * @param value its number; ignored by kinds without one
     * @param length its mean length, seconds; ignored by kinds without one
     * @throws IllegalArgumentException if the number is outside [{@link #minValue()}, {@link #maxValue()}], or the
     *     length outside [{@link FaultKind#MIN_LENGTH}, {@link FaultKind#MAX_LENGTH}]
     */
    F createFault(double value, double length);

    /**
     * {@return a fault of this kind with the default length; see {@link #createFault(double, double)}}
     *
     * @param value the fault's number; ignored by kinds without one
     */
    default F createFault(double value) {
        return createFault(value, FaultKind.DEFAULT_LENGTH);
    }

    /**
     * Checks a number for a fault of this kind.
     *
     * @param value the number
     * @throws IllegalArgumentException if it is outside [{@link #minValue()}, {@link #maxValue()}]
     */
    default void requireAllowed(double value) {
        if (takesValue() && !(value >= minValue() && value <= maxValue())) {
            throw new IllegalArgumentException("a " + fileName() + " fault takes a value from " + minValue() + " to "
                    + maxValue() + ", not " + value);
        }
    }

    /** {@return the name in scenario files, in lower case} */
    default String fileName() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** {@return whether the kind has a number} */
    default boolean takesValue() {
        return minValue() < maxValue();
    }

    /** {@return whether the kind has a length} */
    default boolean takesLength() {
        return false;
    }

    /** {@return the unit of the number, empty for a number without a unit} */
    default String unit() {
        return parameter().unit();
    }

    /** {@return the smallest number allowed} */
    default double minValue() {
        return parameter().min();
    }

    /** {@return the greatest number allowed} */
    default double maxValue() {
        return parameter().max();
    }

    /** {@return the number to use if none is given} */
    default double defaultValue() {
        return parameter().initial();
    }
}
