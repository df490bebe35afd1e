package faultline.control;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.function.Function;

/** Describes which controller drives the robot, and its settings: a scenario's {@code controller} element. */
public sealed interface ControllerSpec {

    /** {@return the wanted distance from the wall, metres; empty for a robot that follows none} */
    default OptionalDouble wantedDistance() {
        return OptionalDouble.empty();
    }

    /** {@return the time between two decisions, seconds; 0 for every tick} */
    default double period() {
        return 0;
    }

    /**
     * {@return the result of the function for this kind of controller}
     *
     * @param <R> the type of the result
     * @param cases a function for each kind
     */
    <R> R match(ControllerCases<R> cases);

    /**
     * A function for each kind of controller.
     *
     * @param <R> the type of the results
     * @param builtIn for a controller of the program
     * @param extern for one that the user has to choose
     * @param provided for one in Java
     * @param chosen for one that the user has chosen
     * @param recorded for the decisions of an earlier run
     */
    record ControllerCases<R>(
            Function<BuiltIn, R> builtIn,
            Function<Extern, R> extern,
            Function<Provided, R> provided,
            Function<Chosen, R> chosen,
            Function<Recorded, R> recorded) {}

    /**
     * A function for each kind of controller of the program.
     *
     * @param <R> the type of the results
     * @param none for a robot that stays where it is
     * @param drive for constant voltages
     * @param wallFollowing for the wall follower
     */
    record BuiltInCases<R>(
            Function<None, R> none, Function<Drive, R> drive, Function<WallFollowing, R> wallFollowing) {}

    /** A controller of the program, which can replace another controller of the program during a run. */
    sealed interface BuiltIn extends ControllerSpec {

        /**
         * {@return the result of the function for this kind of controller}
         *
         * @param <R> the type of the result
         * @param cases a function for each kind
         */
        <R> R matchBuiltIn(BuiltInCases<R> cases);

        @Override
        default <R> R match(ControllerCases<R> cases) {
            return cases.builtIn.apply(this);
        }
    }

    /** The robot stays where it is: file type {@link #TYPE}. */
    record None() implements BuiltIn {
        /** The type in files. */
        public static final String TYPE = "none";

        @Override
        public <R> R matchBuiltIn(BuiltInCases<R> cases) {
            return cases.none.apply(this);
        }
    }

    /**
     * Constant voltages: file type {@link #TYPE}.
     *
     * @param leftVolts the voltage on the left motors, finite
     * @param rightVolts the voltage on the right motors, finite
     */
    record Drive(double leftVolts, double rightVolts) implements BuiltIn {
        /** The type in files. */
        public static final String TYPE = "drive";

        /**
         * Creates settings.
         *
         * @param leftVolts the voltage on the left motors, finite
         * @param rightVolts the voltage on the right motors, finite
         * @throws IllegalArgumentException if a voltage is not finite
         */
        public Drive {
            if (!(Double.isFinite(leftVolts) && Double.isFinite(rightVolts))) {
                throw new IllegalArgumentException("voltages must be finite: " + leftVolts + ", " + rightVolts);
            }
        }

        @Override
        public <R> R matchBuiltIn(BuiltInCases<R> cases) {
            return cases.drive.apply(this);
        }
    }

    /**
     * The paper's six-state wall follower: file type {@link #TYPE}.
     *
     * @param distance the wanted reading of the sensor that faces the wall, metres, positive
     * @param side the side that the wall is kept on
     * @param period the time between two decisions, seconds; 0 for every tick; rounded to whole ticks
     * @param timingRule the rule that defines F3 and F4
     * @param diagnosis whether it watches its sensors and carries on with those that it trusts
     * @param gainRule the rule for the gains of its distance controller
     * @param thresholds when its states are left
     */
    record WallFollowing(
            double distance,
            WallSide side,
            double period,
            TimingRule timingRule,
            boolean diagnosis,
            GainRule gainRule,
            Thresholds thresholds)
            implements BuiltIn {

        /** The type in files. */
        public static final String TYPE = "wall-follower";

        /** The follower that is used where a file gives no values. */
        public static final WallFollowing DEFAULT = new WallFollowing(
                0.25, WallSide.LEFT, 0, TimingRule.EQUAL_READINGS, true, GainRule.AUTOMATIC, Thresholds.DEFAULT);

        /**
         * {@return the same settings with another distance, metres}
         *
         * @param metres the distance, in metres, positive
         */
        public WallFollowing withDistance(double metres) {
            return new WallFollowing(metres, side, period, timingRule, diagnosis, gainRule, thresholds);
        }

        /**
         * {@return the same settings for a wall on another side}
         *
         * @param newSide the side of the wall
         */
        public WallFollowing withSide(WallSide newSide) {
            return new WallFollowing(distance, newSide, period, timingRule, diagnosis, gainRule, thresholds);
        }

        /**
         * {@return the same settings with another timing rule}
         *
         * @param rule the timing rule
         */
        public WallFollowing withTimingRule(TimingRule rule) {
            return new WallFollowing(distance, side, period, rule, diagnosis, gainRule, thresholds);
        }

        /**
         * {@return the same settings with another choice of gains}
         *
         * @param rule the choice of the gains
         */
        public WallFollowing withGainRule(GainRule rule) {
            return new WallFollowing(distance, side, period, timingRule, diagnosis, rule, thresholds);
        }

        /**
         * {@return the same settings with another period}
         *
         * @param seconds the time between two decisions, in seconds; 0 for every tick
         */
        public WallFollowing withPeriod(double seconds) {
            return new WallFollowing(distance, side, seconds, timingRule, diagnosis, gainRule, thresholds);
        }

        /**
         * {@return the same settings with other thresholds}
         *
         * @param values the thresholds
         */
        public WallFollowing withThresholds(Thresholds values) {
            return new WallFollowing(distance, side, period, timingRule, diagnosis, gainRule, values);
        }

        /**
         * {@return the same settings with another threshold}
         *
         * @param threshold the threshold
         * @param value its value, in the unit of its quantity
         * @throws IllegalArgumentException if the value is not within the bounds of its quantity
         */
        public WallFollowing withThreshold(Threshold threshold, double value) {
            return withThresholds(thresholds.with(threshold, value));
        }

        /**
         * {@return whether a running follower can apply other settings and continue from its state}
         *
         * @param other the other settings
         */
        public boolean canContinueWith(WallFollowing other) {
            return side == other.side && period == other.period && diagnosis == other.diagnosis;
        }

        /**
         * {@return other settings for a running follower with these settings}
         *
         * @param other the other settings
         * @throws IllegalArgumentException if the follower cannot continue with them
         */
        public WallFollowing changedTo(BuiltIn other) {
            if (other instanceof WallFollowing follower && canContinueWith(follower)) {
                return follower;
            }
            throw new IllegalArgumentException("a running follower cannot continue with " + other);
        }

        /**
         * {@return the same settings with or without diagnosis}
         *
         * @param on whether the follower watches its sensors
         */
        public WallFollowing withDiagnosis(boolean on) {
            return new WallFollowing(distance, side, period, timingRule, on, gainRule, thresholds);
        }

        @Override
        public OptionalDouble wantedDistance() {
            return OptionalDouble.of(distance);
        }

        @Override
        public <R> R matchBuiltIn(BuiltInCases<R> cases) {
            return cases.wallFollowing.apply(this);
        }

        /**
         * Creates settings.
         *
         * @param distance the wanted reading of the sensor that faces the wall, metres, positive
         * @param side the side that the wall is kept on
         * @param period the time between two decisions, seconds; 0 for every tick; rounded to whole ticks
         * @param timingRule the rule that defines F3 and F4
         * @param diagnosis whether it watches its sensors and carries on with those that it trusts
         * @param gainRule the rule for the gains of its distance controller
         * @param thresholds when its states are left
         * @throws IllegalArgumentException if the distance is not positive and finite, or the period is negative or not
         *     finite
         */
        public WallFollowing {
            requireDistance(distance);
            requirePeriod(period);
        }
    }

    private static void requirePeriod(double period) {
        if (!(period >= 0 && Double.isFinite(period))) {
            throw new IllegalArgumentException("the period must not be negative: " + period);
        }
    }

    private static void requireDistance(double distance) {
        if (!(distance > 0 && Double.isFinite(distance))) {
            throw new IllegalArgumentException("the distance must be positive: " + distance);
        }
    }

    /** A controller that is not part of the program. Its decisions are recorded with the run. */
    sealed interface Foreign extends ControllerSpec {}

    /**
     * A controller from outside that the user has to choose, because a file never starts a program: file type
     * {@link #TYPE}.
     *
     * @param period the time between two decisions, seconds; 0 for every tick
     * @param wanted the distance from the wall that it is measured by, metres, positive
     */
    record Extern(double period, double wanted) implements Foreign {
        /** The type in files. */
        public static final String TYPE = "extern";

        /**
         * Creates settings.
         *
         * @param period the time between two decisions, seconds; 0 for every tick
         * @param wanted the distance from the wall that it is measured by, metres, positive
         * @throws IllegalArgumentException if the period is negative or not finite, or the distance is not positive and
         *     finite
         */
        public Extern {
            requirePeriod(period);
            requireDistance(wanted);
        }

        /**
         * Creates settings with the wall follower's wanted distance.
         *
         * @param period the time between two decisions, seconds; 0 for every tick
         * @throws IllegalArgumentException if the period is negative or not finite
         */
        public Extern(double period) {
            this(period, WallFollowing.DEFAULT.distance());
        }

        @Override
        public OptionalDouble wantedDistance() {
            return OptionalDouble.of(wanted);
        }

        @Override
        public <R> R match(ControllerCases<R> cases) {
            return cases.extern.apply(this);
        }
    }

    /**
     * A controller in Java: the file type is its provider's name.
     *
     * @param name the name of a {@link ControllerProvider}
     * @param period the time between two decisions, seconds; 0 for every tick
     * @param wanted the distance from the wall that it is measured by, metres, positive; it is not passed to it
     * @param settings the settings in the file
     */
    record Provided(String name, double period, double wanted, Map<String, String> settings) implements Foreign {
        /**
         * Creates a choice of a controller from a copy of the settings.
         *
         * @param name the name of a {@link ControllerProvider}
         * @param period the time between two decisions, seconds; 0 for every tick
         * @param wanted the distance from the wall that it is measured by, metres, positive; it is not passed to it
         * @param settings the settings in the file
         * @throws IllegalArgumentException if the period is negative or not finite, or the distance is not positive and
         *     finite
         */
        public Provided {
            requirePeriod(period);
            requireDistance(wanted);
            settings = Map.copyOf(settings);
        }

        /**
         * Creates a choice of a controller with the wall follower's wanted distance from a copy of the settings.
         *
         * @param name the name of a {@link ControllerProvider}
         * @param period the time between two decisions, seconds; 0 for every tick
         * @param settings the settings in the file
         * @throws IllegalArgumentException if the period is negative or not finite
         */
        public Provided(String name, double period, Map<String, String> settings) {
            this(name, period, WallFollowing.DEFAULT.distance(), settings);
        }

        @Override
        public OptionalDouble wantedDistance() {
            return OptionalDouble.of(wanted);
        }

        @Override
        public <R> R match(ControllerCases<R> cases) {
            return cases.provided.apply(this);
        }
    }

    /**
     * A controller that the user has chosen instead of the one in the file. A file that is written names the original.
     *
     * @param original as in the file
     * @param source starts the chosen one
     */
    record Chosen(ControllerSpec original, ControllerSource source) implements Foreign {
        /**
         * Creates a choice of a controller.
         *
         * @param original as in the file
         * @param source starts the chosen one
         */
        public Chosen {
            Objects.requireNonNull(original, "original");
            Objects.requireNonNull(source, "source");
        }

        @Override
        public double period() {
            return original.period();
        }

        @Override
        public OptionalDouble wantedDistance() {
            OptionalDouble wanted = original.wantedDistance();
            return wanted.isPresent() ? wanted : WallFollowing.DEFAULT.wantedDistance();
        }

        @Override
        public <R> R match(ControllerCases<R> cases) {
            return cases.chosen.apply(this);
        }
    }

    /**
     * The decisions of an earlier run: file type {@link #TYPE}.
     *
     * @param wanted the distance from the wall that was wanted, metres
     * @param ticks the number of ticks with decisions
     * @param decisions the decisions, in the order of their ticks
     */
    record Recorded(double wanted, long ticks, List<RecordedDecision> decisions) implements ControllerSpec {
        /** The type in files. */
        public static final String TYPE = "recorded";

        /**
         * Creates a record from a copy of the decisions.
         *
         * @param wanted the distance from the wall that was wanted, metres
         * @param ticks the number of ticks with decisions
         * @param decisions the decisions, in the order of their ticks
         */
        public Recorded {
            decisions = List.copyOf(decisions);
        }

        @Override
        public OptionalDouble wantedDistance() {
            return OptionalDouble.of(wanted);
        }

        @Override
        public <R> R match(ControllerCases<R> cases) {
            return cases.recorded.apply(this);
        }
    }
}
