package faultline.sensor;

/**
 * One way in which a sensor fails. A fault turns what the sensor would have reported into what it does report; several
 * faults on one sensor act in the order in which they came. A fault keeps no state: what is random about it follows
 * from the dice it is given.
 */
public sealed interface Fault permits Fault.Dead, Fault.Stuck, Fault.Bias, Fault.Dropout {

    /**
     * What is reported in place of a reading.
     *
     * @param reading the encoded reading before this fault, see {@link Reading}
     * @param range the sensor's range, metres
     * @param dice the sensor's random numbers for this tick
     * @return the encoded reading after this fault: a distance in [0, range], nothing, or off
     */
    double apply(double reading, double range, SensorRandom dice);

    /**
     * The kind of this fault, as files and windows name it.
     *
     * @return the kind
     */
    FaultKind kind();

    /**
     * The one number of this fault.
     *
     * @return metres or a probability, as the kind says; 0 where the kind has none
     */
    double value();

    /** The sensor gives no answer at all: file kind {@code off}. */
    record Dead() implements Fault {
        @Override
        public double apply(double reading, double range, SensorRandom dice) {
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
        public double apply(double reading, double range, SensorRandom dice) {
            return value <= range ? value : Reading.NOTHING;
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
        public double apply(double reading, double range, SensorRandom dice) {
            double biased = Math.max(0, reading + value);
            return biased <= range ? biased : Reading.NOTHING;
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
        public double apply(double reading, double range, SensorRandom dice) {
            return dice.nextDouble() < value ? Reading.NOTHING : reading;
        }

        @Override
        public FaultKind kind() {
            return FaultKind.DROPOUT;
        }
    }
}
