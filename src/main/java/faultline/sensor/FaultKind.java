package faultline.sensor;

import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleFunction;

/** The kinds of fault by the names that scenario files and windows use, each with its one number. */
public enum FaultKind {

    /** No answer at all; no number. */
    OFF("", 0, 0, 0, value -> new Fault.Dead()),

    /** One distance whatever is seen; the number is that distance. */
    STUCK("m", 0, 100, 0.4, Fault.Stuck::new),

    /** An error on every distance; the number is the error. */
    BIAS("m", -100, 100, 0.05, Fault.Bias::new),

    /** Sees nothing in some ticks; the number is their share. */
    DROPOUT("", 0, 1, 0.5, Fault.Dropout::new);

    private final String unit;
    private final double minValue;
    private final double maxValue;
    private final double defaultValue;
    private final DoubleFunction<Fault> factory;

    FaultKind(String unit, double least, double most, double usual, DoubleFunction<Fault> factory) {
        this.unit = unit;
        this.minValue = least;
        this.maxValue = most;
        this.defaultValue = usual;
        this.factory = factory;
    }

    /**
     * The kind with a name.
     *
     * @param name the name in a file, in lower case
     * @return the kind, empty where there is none of that name
     */
    public static Optional<FaultKind> ofFileName(String name) {
        for (FaultKind kind : values()) {
            if (kind.fileName().equals(name)) {
                return Optional.of(kind);
            }
        }
        return Optional.empty();
    }

    /**
     * The name in scenario files.
     *
     * @return lower case
     */
    public String fileName() {
        return name().toLowerCase(Locale.ROOT);
    }

    /**
     * Makes a fault of this kind.
     *
     * @param value its number, ignored by kinds without one
     * @return the fault
     * @throws IllegalArgumentException if the number is outside [{@link #minValue()}, {@link #maxValue()}]
     */
    public Fault createFault(double value) {
        if (takesValue() && !(value >= minValue && value <= maxValue)) {
            throw new IllegalArgumentException(
                    "a " + fileName() + " fault takes a value from " + minValue + " to " + maxValue + ", not " + value);
        }
        return factory.apply(value);
    }

    /**
     * Whether the kind has a number.
     *
     * @return false for {@link #OFF}
     */
    public boolean takesValue() {
        return this != OFF;
    }

    /**
     * The unit of the number.
     *
     * @return "m", or empty for a number without unit
     */
    public String unit() {
        return unit;
    }

    /**
     * The least number allowed.
     *
     * @return in the unit
     */
    public double minValue() {
        return minValue;
    }

    /**
     * The greatest number allowed.
     *
     * @return in the unit
     */
    public double maxValue() {
        return maxValue;
    }

    /**
     * The number where none is given.
     *
     * @return in the unit
     */
    public double defaultValue() {
        return defaultValue;
    }
}
