package faultline.control;

import java.util.function.Function;

/** The rule for the gains of the PD distance controller. */
public sealed interface GainRule {

    /** The gains that suit the speed and the motors. */
    GainRule AUTOMATIC = new Automatic();

    /**
     * {@return the gains}
     *
     * @param speed metres per second
     * @param lag the motors' time constant and the control's delay, seconds
     */
    PdGains gains(double speed, double lag);

    /**
     * {@return the result of the function for this kind of rule}
     *
     * @param <R> the type of the result
     * @param cases a function for each kind
     */
    <R> R match(GainCases<R> cases);

    /**
     * A function for each kind of rule.
     *
     * @param <R> the type of the results
     * @param automatic for the automatic rule
     * @param length for a length
     * @param fixed for given gains
     */
    record GainCases<R>(Function<Automatic, R> automatic, Function<Length, R> length, Function<Fixed, R> fixed) {}

    /** Critically damped, with the shortest length that the motors can follow. */
    record Automatic() implements GainRule {
        @Override
        public PdGains gains(double speed, double lag) {
            return PdGains.forSpeed(speed, lag);
        }

        @Override
        public <R> R match(GainCases<R> cases) {
            return cases.automatic.apply(this);
        }
    }

    /**
     * Critically damped.
     *
     * @param metres the length over which an error decays, positive
     */
    record Length(double metres) implements GainRule {
        /**
         * Creates the rule.
         *
         * @param metres the length over which an error decays, positive
         * @throws IllegalArgumentException if the length is not positive and finite
         */
        public Length {
            requirePositive(metres);
        }

        @Override
        public PdGains gains(double speed, double lag) {
            return PdGains.criticallyDamped(metres, speed);
        }

        @Override
        public <R> R match(GainCases<R> cases) {
            return cases.length.apply(this);
        }
    }

    /**
     * Given gains.
     *
     * @param proportional k_p, radians per second for each metre, positive
     * @param derivative k_d, radians per second for each metre per second, positive
     */
    record Fixed(double proportional, double derivative) implements GainRule {
        /**
         * Creates the rule.
         *
         * @param proportional k_p, radians per second for each metre, positive
         * @param derivative k_d, radians per second for each metre per second, positive
         * @throws IllegalArgumentException if a gain is not positive and finite
         */
        public Fixed {
            requirePositive(proportional);
            requirePositive(derivative);
        }

        @Override
        public PdGains gains(double speed, double lag) {
            return PdGains.withErrorLimit(proportional, derivative, speed);
        }

        @Override
        public <R> R match(GainCases<R> cases) {
            return cases.fixed.apply(this);
        }
    }

    private static void requirePositive(double value) {
        if (!(value > 0 && Double.isFinite(value))) {
            throw new IllegalArgumentException("a length or gain must be positive: " + value);
        }
    }
}
