package faultline.robot;

/**
 * A way in which the motors of a side fail. A fault changes the voltage that reaches them, after the supply has limited
 * it; the faults of one side act in the order in which they were added.
 */
public sealed interface MotorFault permits MotorFault.Weak, MotorFault.NoDrive, MotorFault.DeadBand {

    /**
     * {@return the voltage that has an effect}
     *
     * @param volts the voltage that is applied
     */
    double apply(double volts);

    /** {@return the kind of this fault, by its name in files and windows} */
    MotorFaultKind kind();

    /** {@return the number of this fault in the kind's unit; 0 if the kind has none} */
    default double value() {
        return 0;
    }

    /**
     * Only a share of the voltage has an effect, so the wheels turn slower: file kind {@code weak}.
     *
     * @param value the share, 0 to 1
     */
    record Weak(double value) implements MotorFault {
        /**
         * Creates the fault.
         *
         * @param value the share
         * @throws IllegalArgumentException if the value is outside the limits of {@link MotorFaultKind#WEAK}
         */
        public Weak {
            MotorFaultKind.WEAK.requireAllowed(value);
        }

        @Override
        public double apply(double volts) {
            return value * volts;
        }

        @Override
        public MotorFaultKind kind() {
            return MotorFaultKind.WEAK;
        }
    }

    /** No voltage has an effect, so the wheels stop: file kind {@code dead}. */
    record NoDrive() implements MotorFault {
        @Override
        public double apply(double volts) {
            return 0;
        }

        @Override
        public MotorFaultKind kind() {
            return MotorFaultKind.DEAD;
        }
    }

    /**
     * A part of the voltage is needed to overcome friction, and only the rest has an effect: file kind
     * {@code dead-band}.
     *
     * @param value half the width of the band, volts
     */
    record DeadBand(double value) implements MotorFault {
        /**
         * Creates the fault.
         *
         * @param value half the width of the band, volts
         * @throws IllegalArgumentException if the value is outside the limits of {@link MotorFaultKind#DEAD_BAND}
         */
        public DeadBand {
            MotorFaultKind.DEAD_BAND.requireAllowed(value);
        }

        @Override
        public double apply(double volts) {
            return Math.copySign(Math.max(0, Math.abs(volts) - value), volts);
        }

        @Override
        public MotorFaultKind kind() {
            return MotorFaultKind.DEAD_BAND;
        }
    }
}
