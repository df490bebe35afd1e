package faultline.control;

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
     * {@return the result of a visitor for this rule}
     *
     * @param <R> the result type
     * @param visitor the visitor
     */
    <R> R accept(GainRuleVisitor<R> visitor);

    /**
     * An operation with one method for each rule.
     *
     * @param <R> the result type
     */
    interface GainRuleVisitor<R> {
        /**
         * {@return the result for {@link Automatic}}
         *
         * @param rule the rule to visit
         */
        R visit(Automatic rule);

        /**
         * {@return the result for a {@link Length}}
         *
         * @param rule the rule to visit
         */
        R visit(Length rule);

        /**
         * {@return the result for {@link Fixed} gains}
         *
         * @param rule the rule to visit
         */
        R visit(Fixed rule);
    }

    /** Critically damped, with the shortest length that the motors can follow. */
    record Automatic() implements GainRule {
        @Override
        public PdGains gains(double speed, double lag) {
            return PdGains.forSpeed(speed, lag);
        }

        @Override
        public <R> R accept(GainRuleVisitor<R> visitor) {
            return visitor.visit(this);
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
        public <R> R accept(GainRuleVisitor<R> visitor) {
            return visitor.visit(this);
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
        public <R> R accept(GainRuleVisitor<R> visitor) {
            return visitor.visit(this);
        }
    }

    private static void requirePositive(double value) {
        if (!(value > 0 && Double.isFinite(value))) {
            throw new IllegalArgumentException("a length or gain must be positive: " + value);
        }
    }
}
