package faultline.sensor;

/**
 * A way in which a sensor fails. A fault changes the reading that the sensor would have reported; the faults of one
 * sensor act in the order in which they were added. A fault is a value: its state is kept in the {@link FaultContext}
 * that is created when it begins.
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
     * Returns the reading to report; the reading itself if the fault changes what the sensor sees.
     *
     * @param reading the encoded reading before this fault, see {@link Reading}
     * @param context the context of this fault at this tick
     * @return the encoded reading after this fault: a distance in [0, range], nothing, or off
     */
    default double apply(double reading, FaultContext context) {
        return reading;
    }

    /** {@return the kind of this fault} */
    default FaultKind kind() {
        return FaultKind.of(this);
    }

    /** {@return the number of this fault, in the unit of its kind; 0 if the kind has none} */
    default double value() {
        return 0;
    }

    /** {@return the mean length of this fault's periods, seconds; 0 for a kind without a length} */
    default double length() {
        return 0;
    }

    /**
     * {@return the optics of the sensor with this fault}
     *
     * @param spec the sensor without it
     */
    default SensorSpec optics(SensorSpec spec) {
        return spec;
    }

    /** {@return the greatest angle of incidence at which any flat surface is sensed, radians} */
    default double specularAngle() {
        return StrictMath.PI / 2;
    }

    /** The sensor does not answer: file kind {@code off}. */
    record Dead() implements Fault {
        @Override
        public double apply(double reading, FaultContext context) {
            return Reading.OFF;
        }
    }

    /**
     * The sensor always reports the same distance: file kind {@code stuck}.
     *
     * @param value the reported distance, metres, not negative; nothing if it is beyond the range
     */
    record Stuck(double value) implements Fault {
        /**
         * Creates the fault.
         *
         * @param value the reported distance, metres, not negative; nothing if it is beyond the range
         * @throws IllegalArgumentException if the value is outside the limits of {@link FaultKind#STUCK}
         */
        public Stuck {
            FaultKind.STUCK.requireAllowed(value);
        }

        @Override
        public double apply(double reading, FaultContext context) {
            return value <= context.range() ? value : Reading.NOTHING;
        }
    }

    /**
     * The sensor adds an error to every distance: file kind {@code bias}. The sum is not less than 0, and nothing if it
     * is beyond the range.
     *
     * @param value the error, metres, positive for too far
     */
    record Bias(double value) implements Fault {
        /**
         * Creates the fault.
         *
         * @param value the error, metres, positive for too far
         * @throws IllegalArgumentException if the value is outside the limits of {@link FaultKind#BIAS}
         */
        public Bias {
            FaultKind.BIAS.requireAllowed(value);
        }

        @Override
        public double apply(double reading, FaultContext context) {
            return Reading.encode(reading + value, context.range());
        }
    }

    /**
     * The sensor sees nothing in some ticks: file kind {@code dropout}.
     *
     * @param value the share of such ticks, in [0, 1]; the ticks are independent
     */
    record Dropout(double value) implements Fault {
        /**
         * Creates the fault.
         *
         * @param value the share of ticks in which nothing is seen, in [0, 1]
         * @throws IllegalArgumentException if the value is outside the limits of {@link FaultKind#DROPOUT}
         */
        public Dropout {
            FaultKind.DROPOUT.requireAllowed(value);
        }

        @Override
        public double apply(double reading, FaultContext context) {
            return context.random().nextDouble() < value ? Reading.NOTHING : reading;
        }
    }
}
