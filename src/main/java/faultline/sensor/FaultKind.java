package faultline.sensor;

import java.util.Arrays;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * The kinds of fault with the names that scenario files use, each with the bounds of its number. A new kind needs one
 * line here and one record that {@link Fault} permits; {@link #changesOptics()} lists the kinds that change what is
 * seen.
 */
public enum FaultKind implements FaultDescriptor<Fault> {

    /** No answer; no number. */
    OFF(Family.SILENT, "", 0, 0, 0, (value, length) -> new Fault.Dead()),

    /** Always the same distance; the number is that distance. */
    STUCK(Family.CONSTANT, "m", 0, 100, 0.4, (value, length) -> new Fault.Stuck(value)),

    /** An error on every distance; the number is the error. */
    BIAS(Family.SHIFTED, "m", -100, 100, 0.05, (value, length) -> new Fault.Bias(value)),

    /** Sees nothing in some ticks; the number is their share. */
    DROPOUT(Family.INTERMITTENT, "", 0, 1, 0.5, (value, length) -> new Fault.Dropout(value)),

    /** Always the last reading before the fault; no number. */
    STUCK_AT_LAST(Family.CONSTANT, "", 0, 0, 0, (value, length) -> new SignalFault.StuckAtLast()),

    /** Every distance multiplied; the number is the factor. */
    SCALE(Family.SHIFTED, "", 0.01, 100, 1.2, (value, length) -> new SignalFault.Scale(value)),

    /** An error that grows; the number is its rate. */
    DRIFT(Family.SHIFTED, "m/s", -1, 1, 0.01, (value, length) -> new SignalFault.Drift(value)),

    /** Gaussian noise on every distance; the number is its standard deviation. */
    NOISE(Family.SHIFTED, "m", 0, 10, 0.03, (value, length) -> new SignalFault.Noise(value)),

    /** Distances in coarse steps; the number is the step. */
    QUANTISED(Family.SHIFTED, "m", 0.001, 10, 0.05, (value, length) -> new SignalFault.Quantised(value)),

    /**
     * Sees nothing in bursts; the number is the rate at which they begin, the length is their mean duration, which is
     * at least one tick.
     */
    BURSTS(Family.INTERMITTENT, "1/s", 0, 100, 0.5, SignalFault.Bursts::new),

    /** Reports late; the number is the delay. */
    DELAYED(Family.SHIFTED, "s", 0, 10, 0.2, (value, length) -> new SignalFault.Delayed(value)),

    /** Dirt: sees nothing beyond a distance; the number is that distance. */
    SHORT_RANGE(Family.INTERMITTENT, "m", 0.01, 100, 0.2, (value, length) -> new OpticalFault.ShortRange(value)),

    /** Has another field of view; the number is its full angle. */
    CONE(Family.SHIFTED, "deg", 0.1, 179, 4, (value, length) -> new OpticalFault.Cone(value)),

    /** Reports something at a random distance in some ticks; the number is their share. */
    GHOST(Family.INTERMITTENT, "", 0, 1, 0.2, (value, length) -> new SignalFault.Ghost(value)),

    /** Sees the neighbour's light in some ticks; the number is their share. */
    CROSS_TALK(Family.INTERMITTENT, "", 0, 1, 0.5, (value, length) -> new SignalFault.CrossTalk(value)),

    /** Does not see slanted surfaces; the number is the greatest angle of incidence that it sees. */
    SPECULAR_LOSS(Family.INTERMITTENT, "deg", 0.1, 90, 30, (value, length) -> new OpticalFault.SpecularLoss(value)),

    /** Has a wrong bearing; the number is the error. */
    MISALIGNED(Family.SHIFTED, "deg", -180, 180, 15, (value, length) -> new OpticalFault.Misaligned(value));

    /** The properties of kinds that decide how they are drawn. */
    public enum Family {
        /** No answer. */
        SILENT,
        /** Always the same distance. */
        CONSTANT,
        /** Wrong distances. */
        SHIFTED,
        /** Readings that appear and disappear. */
        INTERMITTENT
    }

    /** The mean length of a burst if none is given, seconds. */
    public static final double DEFAULT_LENGTH = 0.5;

    /** The shortest mean length of a burst, seconds. */
    public static final double MIN_LENGTH = 0.001;

    /** The longest mean length of a burst, seconds. */
    public static final double MAX_LENGTH = 1000;

    private static final Map<Class<?>, FaultKind> BY_TYPE = Arrays.stream(values())
            .collect(Collectors.toMap(
                    kind -> kind.createFault(kind.defaultValue()).getClass(), kind -> kind));

    private interface Factory {
        Fault create(double value, double length);
    }

    private final Family family;
    private final Parameter parameter;
    private final Factory factory;

    FaultKind(Family family, String unit, double least, double most, double initial, Factory factory) {
        this.family = family;
        this.parameter = new Parameter(unit, least, most, initial);
        this.factory = factory;
    }

    static FaultKind of(Fault fault) {
        return BY_TYPE.get(fault.getClass());
    }

    @Override
    public Parameter parameter() {
        return parameter;
    }

    @Override
    public Fault createFault(double value, double length) {
        return factory.create(value, length);
    }

    /** {@return the properties that all kinds have} */
    public Family family() {
        return family;
    }

    /** {@return whether the kind changes what the sensor sees, and not only what it reports} */
    public boolean changesOptics() {
        return this == CONE || this == SPECULAR_LOSS || this == MISALIGNED;
    }

    @Override
    public boolean takesLength() {
        return this == BURSTS;
    }
}
