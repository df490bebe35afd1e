package faultline.robot;

import java.util.Locale;
import java.util.function.DoubleFunction;

/**
 * The kinds of fault of motors with the names that scenario files use, each with the bounds of its number. A new kind
 * needs one line here and one record.
 */
public enum MotorFaultKind {

    /** Part of the voltage has an effect; the number is that share. */
    WEAK("", 0, 1, 0.7, MotorFault.Weak::new),

    /** No voltage has an effect; no number. */
    DEAD("", 0, 0, 0, value -> new MotorFault.Dead()),

    /** Small voltages have no effect; the number is the greatest of them. */
    DEAD_BAND("V", 0, 10_000, 0.5, MotorFault.DeadBand::new);

    private final String unit;
    private final double minValue;
    private final double maxValue;
    private final double defaultValue;
    private final DoubleFunction<MotorFault> factory;

    MotorFaultKind(String unit, double least, double most, double initial, DoubleFunction<MotorFault> factory) {
        this.unit = unit;
        this.minValue = least;
        this.maxValue = most;
        this.defaultValue = initial;
        this.factory = factory;
    }

    /** {@return the name in scenario files, in lower case} */
    public String fileName() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /**
     * {@return a fault of this kind}
     *
     * @param value its number; ignored by kinds without one
     * @throws IllegalArgumentException if the number is outside [{@link #minValue}, {@link #maxValue}]
     */
    public MotorFault createFault(double value) {
        if (takesValue() && !(value >= minValue && value <= maxValue)) {
            throw new IllegalArgumentException(
                    "a " + fileName() + " fault takes a value from " + minValue + " to " + maxValue + ", not " + value);
        }
        return factory.apply(value);
    }

    /** {@return whether the kind has a number} */
    public boolean takesValue() {
        return this != DEAD;
    }

    /** {@return the unit of the number, empty for a number without unit} */
    public String unit() {
        return unit;
    }

    /** {@return the least number allowed} */
    public double minValue() {
        return minValue;
    }

    /** {@return the greatest number allowed} */
    public double maxValue() {
        return maxValue;
    }

    /** {@return the number where none is given} */
    public double defaultValue() {
        return defaultValue;
    }
}
