package faultline.sensor;

/** Faults of the signal, which change a distance after it was measured and before the controller gets it. */
public final class SignalFault {

    private SignalFault() {}

    /** Always reports the last reading before the fault: file kind {@code stuck-at-last}. */
    public record StuckAtLast() implements Fault {
        @Override
        public double apply(double reading, FaultContext context) {
            double held = context.heldReading();
            return Reading.isOff(held) ? held : Reading.encode(held, context.range());
        }
    }

    /**
     * r' = k r: file kind {@code scale}.
     *
     * @param value the factor k, positive
     */
    public record Scale(double value) implements Fault {
        /**
         * Creates the fault.
         *
         * @param value the factor k, positive
         * @throws IllegalArgumentException if the value is outside the limits of {@link FaultKind#SCALE}
         */
        public Scale {
            FaultKind.SCALE.requireAllowed(value);
        }

        @Override
        public double apply(double reading, FaultContext context) {
            return Reading.encode(value * reading, context.range());
        }
    }

    /**
     * r' = r + c (t - t0): file kind {@code drift}.
     *
     * @param value the rate c, metres per second
     */
    public record Drift(double value) implements Fault {
        /**
         * Creates the fault.
         *
         * @param value the rate c, metres per second
         * @throws IllegalArgumentException if the value is outside the limits of {@link FaultKind#DRIFT}
         */
        public Drift {
            FaultKind.DRIFT.requireAllowed(value);
        }

        @Override
        public double apply(double reading, FaultContext context) {
            return Reading.encode(reading + value * context.age(), context.range());
        }
    }

    /**
     * r' = r + n, n normal with mean 0: file kind {@code noise}.
     *
     * @param value the standard deviation, metres
     */
    public record Noise(double value) implements Fault {
        /**
         * Creates the fault.
         *
         * @param value the standard deviation, metres
         * @throws IllegalArgumentException if the value is outside the limits of {@link FaultKind#NOISE}
         */
        public Noise {
            FaultKind.NOISE.requireAllowed(value);
        }

        @Override
        public double apply(double reading, FaultContext context) {
            return Reading.encode(reading + value * context.random().nextGaussian(), context.range());
        }
    }

    /**
     * r' = q round(r / q): file kind {@code quantised}.
     *
     * @param value the step q, metres, positive
     */
    public record Quantised(double value) implements Fault {
        /**
         * Creates the fault.
         *
         * @param value the step q, metres, positive
         * @throws IllegalArgumentException if the value is outside the limits of {@link FaultKind#QUANTISED}
         */
        public Quantised {
            FaultKind.QUANTISED.requireAllowed(value);
        }

        @Override
        public double apply(double reading, FaultContext context) {
            return reading == Reading.NOTHING
                    ? reading
                    : Reading.encode(value * Math.floor(reading / value + 0.5), context.range());
        }
    }

    /**
     * Sees nothing in bursts, a two-state Markov chain (Gilbert 1960): file kind {@code bursts}. A burst lasts at least
     * one tick, so a shorter mean length counts as one tick, and a rate above one burst a tick as one a tick.
     *
     * @param value the rate at which bursts begin, per second outside bursts
     * @param length the mean length of a burst, seconds, positive
     */
    public record Bursts(double value, double length) implements Fault {
        /**
         * Creates bursts of missing readings.
         *
         * @param value the rate at which bursts begin, per second outside bursts
         * @param length the mean length of a burst, seconds, positive
         * @throws IllegalArgumentException if the rate or the length is outside the limits of {@link FaultKind#BURSTS}
         */
        public Bursts {
            FaultKind.BURSTS.requireAllowed(value);
            if (!(length >= FaultKind.MIN_LENGTH && length <= FaultKind.MAX_LENGTH)) {
                throw new IllegalArgumentException("the length of bursts is out of range: " + length);
            }
        }

        @Override
        public double apply(double reading, FaultContext context) {
            return context.inBurst(value, length) ? Reading.NOTHING : reading;
        }
    }

    /**
     * r'(t) = r(t - d): file kind {@code delayed}.
     *
     * @param value the delay d, seconds
     */
    public record Delayed(double value) implements Fault {
        /**
         * Creates the fault.
         *
         * @param value the delay d, seconds
         * @throws IllegalArgumentException if the value is outside the limits of {@link FaultKind#DELAYED}
         */
        public Delayed {
            FaultKind.DELAYED.requireAllowed(value);
        }

        @Override
        public double apply(double reading, FaultContext context) {
            return Reading.encode(context.delayed(reading, value), context.range());
        }
    }

    /**
     * In a share of ticks, reports a uniformly random distance if it is less than the reading: file kind {@code ghost}.
     *
     * @param value the share, in [0, 1]
     */
    public record Ghost(double value) implements Fault {
        /**
         * Creates the fault.
         *
         * @param value the share, in [0, 1]
         * @throws IllegalArgumentException if the value is outside the limits of {@link FaultKind#GHOST}
         */
        public Ghost {
            FaultKind.GHOST.requireAllowed(value);
        }

        @Override
        public double apply(double reading, FaultContext context) {
            double chance = context.random().nextDouble();
            double distance = context.range() * context.random().nextDouble();
            return chance < value ? Math.min(reading, distance) : reading;
        }
    }

    /**
     * r' = min(r, r of the next sensor) in a share of ticks: file kind {@code cross-talk}.
     *
     * @param value the share, in [0, 1]
     */
    public record CrossTalk(double value) implements Fault {
        /**
         * Creates the fault.
         *
         * @param value the share, in [0, 1]
         * @throws IllegalArgumentException if the value is outside the limits of {@link FaultKind#CROSS_TALK}
         */
        public CrossTalk {
            FaultKind.CROSS_TALK.requireAllowed(value);
        }

        @Override
        public double apply(double reading, FaultContext context) {
            boolean mixed = context.random().nextDouble() < value;
            return mixed ? Reading.encode(Math.min(reading, context.neighbourReading()), context.range()) : reading;
        }
    }
}
