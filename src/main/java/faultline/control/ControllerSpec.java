package faultline.control;

/** Describes which controller drives the robot, and its settings: a scenario's {@code controller} element. */
public sealed interface ControllerSpec {

    /** The robot stays where it is: file type {@code none}. */
    record None() implements ControllerSpec {}

    /**
     * Constant voltages: file type {@code drive}.
     *
     * @param leftVolts on the left motors, finite
     * @param rightVolts on the right motors, finite
     */
    record Drive(double leftVolts, double rightVolts) implements ControllerSpec {}

    /**
     * The paper's six-state wall follower: file type {@code wall-follower}.
     *
     * @param distance the wanted reading of the sensor that faces the wall, metres, positive
     * @param side the side that the wall is kept on
     * @param period how often it decides, seconds; 0 for every tick; rounded to whole ticks
     * @param timingRule which moments are F3 and F4
     * @param diagnosis whether it watches its sensors and carries on with those that it trusts
     */
    record WallFollowing(double distance, WallSide side, double period, TimingRule timingRule, boolean diagnosis)
            implements ControllerSpec {

        /** The follower that is used where a file gives no values. */
        public static final WallFollowing DEFAULT =
                new WallFollowing(0.25, WallSide.LEFT, 0, TimingRule.EQUAL_READINGS, true);

        /** Settings with diagnosis. */
        public WallFollowing(double distance, WallSide side, double period, TimingRule timingRule) {
            this(distance, side, period, timingRule, true);
        }

        /** Returns the same settings with or without diagnosis. */
        public WallFollowing withDiagnosis(boolean on) {
            return new WallFollowing(distance, side, period, timingRule, on);
        }

        public WallFollowing {
            if (!(distance > 0 && Double.isFinite(distance))) {
                throw new IllegalArgumentException("the distance must be positive: " + distance);
            }
            if (!(period >= 0 && Double.isFinite(period))) {
                throw new IllegalArgumentException("the period must not be negative: " + period);
            }
        }
    }
}
