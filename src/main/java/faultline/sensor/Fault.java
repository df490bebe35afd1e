package faultline.sensor;

/**
 * One way in which a sensor fails. A fault turns what the sensor would have reported into what it does report; several
 * faults on one sensor act in the order in which they came. A fault itself is a value: what it remembers of its past is
 * kept in the {@link FaultContext} that is made for it when it sets in.
 */
public sealed interface Fault
        permits Fault.Dead,
                Fault.Stuck,
                Fault.Bias,
                Fault.Dropout,
                SignalFault.StuckAtLast,
                SignalFault.Scale,
                SignalFault.Drift,
                SignalFault.Noise,
                SignalFault.Quantised,
                SignalFault.Bursts,
                SignalFault.Delayed,
                SignalFault.Ghost,
                SignalFault.CrossTalk,
                OpticalFault.ShortRange,
                OpticalFault.Cone,
                OpticalFault.SpecularLoss,
                OpticalFault.Misaligned {

    /**
     * What is reported in place of a reading.
     *
     * @param reading the encoded reading before this fault, see {@link Reading}
     * @param context of this fault at this tick
     * @return the encoded reading after this fault: a distance in [0, range], nothing, or off
     */
    double apply(double reading, FaultContext context);

    /**
     * The kind of this fault, as files and windows name it.
     *
     * @return the kind
     */
    FaultKind kind();

    /**
     * The number of this fault.
     *
     * @return in the kind's unit; 0 if the kind has none
     */
    double value();

    /**
     * How long the fault lasts each time that it comes.
     *
     * @return seconds; 0 for a kind that has no length
     */
    default double length() {
        return 0;
    }

    /**
     * Returns the optics of the sensor with this fault.
     *
     * @param spec without it
     */
    default SensorSpec optics(SensorSpec spec) {
        return spec;
    }

    /** Returns the greatest angle of incidence at which a surface still answers the sensor, radians. */
    default double specularAngle() {
        return StrictMath.PI / 2;
    }

    /** The sensor gives no answer at all: file kind {@code off}. */
    record Dead() implements Fault {
        @Override
        public double apply(double reading, FaultContext context) {
            return Reading.OFF;
        }

        @Override
        public FaultKind kind() {
            return FaultKind.OFF;
        }

        @Override
        public double value() {
            return 0;
        }
    }

    /**
     * The sensor reports one distance whatever it sees: file kind {@code stuck}.
     *
     * @param value the reported distance, metres, not negative; beyond the range it reads as nothing
     */
    record Stuck(double value) implements Fault {
        @Override
        public double apply(double reading, FaultContext context) {
            return value <= context.range() ? value : Reading.NOTHING;
        }

        @Override
        public FaultKind kind() {
            return FaultKind.STUCK;
        }
    }

    /**
     * The sensor adds an error to every distance: file kind {@code bias}. The sum is held at 0 below, and reads as
     * nothing beyond the range.
     *
     * @param value the error, metres, positive for too far
     */
    record Bias(double value) implements Fault {
        @Override
        public double apply(double reading, FaultContext context) {
            double biased = Math.max(0, reading + value);
            return biased <= context.range() ? biased : Reading.NOTHING;
        }

        @Override
        public FaultKind kind() {
            return FaultKind.BIAS;
        }
    }

    /**
     * The sensor now and then sees nothing: file kind {@code dropout}.
     *
     * @param value the share of ticks in which it does, in [0, 1], each tick on its own
     */
    record Dropout(double value) implements Fault {
        @Override
        public double apply(double reading, FaultContext context) {
            return context.random().nextDouble() < value ? Reading.NOTHING : reading;
        }

        @Override
        public FaultKind kind() {
            return FaultKind.DROPOUT;
        }
    }
}
