package faultline.engine.metrics;

import faultline.control.ControllerState;
import faultline.io.DecimalText;
import faultline.world.Collision;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * An expectation about the result of a scenario's run.
 *
 * @param conditions must all hold
 */
public record Expectation(List<Condition> conditions) {

    /** Expects nothing. */
    public static final Expectation NONE = new Expectation(List.of());

    /** The decimals in sentences: millimetres and milliseconds, and those of the summary. */
    private static final int COLLISION_DECIMALS = 3;

    private static final int COVERAGE_DECIMALS = 4;
    private static final int RMS_DECIMALS = 6;

    /**
     * Creates an expectation from a copy of the conditions.
     *
     * @param conditions must all hold
     */
    public Expectation {
        conditions = List.copyOf(conditions);
    }

    /**
     * {@return this expectation without the conditions about other states}
     *
     * @param states the states that a controller has
     */
    public Expectation withStatesIn(Collection<ControllerState> states) {
        ConditionCases<Boolean> possible = new ConditionCases<>(
                collides -> true,
                coverage -> true,
                distance -> true,
                visited -> states.contains(visited.state()),
                last -> states.contains(last.state()));
        return new Expectation(conditions.stream()
                .filter(condition -> condition.match(possible))
                .toList());
    }

    /**
     * {@return the conditions that do not hold in a run, one sentence for each}
     *
     * @param facts the facts of the run
     */
    public List<String> unmet(RunFacts facts) {
        return conditions.stream()
                .flatMap(condition -> condition.unmet(facts).stream())
                .toList();
    }

    /**
     * A condition on the result of a run. Code that depends on the kind of condition gives {@link ConditionCases}, so
     * that a new kind does not compile until it is handled everywhere.
     */
    public sealed interface Condition {

        /**
         * {@return the result of the function for this kind of condition}
         *
         * @param <R> the type of the result
         * @param cases a function for each kind
         */
        <R> R match(ConditionCases<R> cases);

        /**
         * {@return a sentence about how the run fails to meet the condition; empty if the condition is met}
         *
         * @param facts the facts of the run
         */
        Optional<String> unmet(RunFacts facts);

        private static Optional<String> expected(String wanted, String found) {
            return Optional.of("expected " + wanted + ", but " + found);
        }

        /** Describes a value with some decimals, or exactly if it would then seem to be within its limit. */
        private static String describe(double value, double limit, int decimals, String otherwise) {
            if (Double.isNaN(value)) {
                return otherwise;
            }
            String rounded = round(value, decimals);
            boolean sameSide = Double.compare(Double.parseDouble(rounded), limit) == Double.compare(value, limit);
            return "it is " + (sameSide ? rounded : DecimalText.format(value));
        }

        private static String round(double value, int decimals) {
            BigDecimal rounded = new BigDecimal(DecimalText.format(value)).setScale(decimals, RoundingMode.HALF_UP);
            return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
        }
    }

    /**
     * A function for each kind of condition.
     *
     * @param <R> the type of the results
     * @param collides for whether the robot collides
     * @param minCoverage for the smallest share of the wall
     * @param maxDistanceRms for the greatest distance error
     * @param visitedState for a state that is passed through
     * @param finalState for the last state
     */
    public record ConditionCases<R>(
            Function<Collides, R> collides,
            Function<MinCoverage, R> minCoverage,
            Function<MaxDistanceRms, R> maxDistanceRms,
            Function<VisitedState, R> visitedState,
            Function<FinalState, R> finalState) {}

    /**
     * Whether the robot collides.
     *
     * @param wanted whether it is expected to
     */
    public record Collides(boolean wanted) implements Condition {

        @Override
        public <R> R match(ConditionCases<R> cases) {
            return cases.collides.apply(this);
        }

        @Override
        public Optional<String> unmet(RunFacts facts) {
            return wanted == facts.collision().isPresent()
                    ? Optional.empty()
                    : Condition.expected(
                            wanted ? "a collision" : "no collision",
                            facts.collision().map(Collides::describe).orElse("there was none"));
        }

        private static String describe(Collision collision) {
            return "the robot struck " + collision.obstacle() + " at "
                    + Condition.round(collision.point().x(), COLLISION_DECIMALS) + ","
                    + Condition.round(collision.point().y(), COLLISION_DECIMALS) + " after "
                    + Condition.round(collision.time(), COLLISION_DECIMALS) + " s";
        }
    }

    /**
     * The smallest share of the wall that is followed.
     *
     * @param share the share, in [0, 1]
     */
    public record MinCoverage(double share) implements Condition {

        /**
         * Creates a condition.
         *
         * @param share the share, in [0, 1]
         * @throws IllegalArgumentException if the share is outside [0, 1]
         */
        public MinCoverage {
            if (!(share >= 0 && share <= 1)) {
                throw new IllegalArgumentException("a share must be in [0, 1]: " + share);
            }
        }

        @Override
        public <R> R match(ConditionCases<R> cases) {
            return cases.minCoverage.apply(this);
        }

        @Override
        public Optional<String> unmet(RunFacts facts) {
            return facts.coverage().orElse(0) >= share
                    ? Optional.empty()
                    : Condition.expected(
                            "a coverage of at least " + DecimalText.format(share),
                            Condition.describe(
                                    facts.coverage().orElse(Double.NaN),
                                    share,
                                    COVERAGE_DECIMALS,
                                    facts.isPathTooLong() ? "it is not known" : "no wall was followed"));
        }
    }

    /**
     * The greatest distance error on straight walls.
     *
     * @param metres the root mean square of the error, metres, positive
     */
    public record MaxDistanceRms(double metres) implements Condition {

        /**
         * Creates a condition.
         *
         * @param metres the root mean square of the error, metres, positive
         * @throws IllegalArgumentException if the error is not positive and finite
         */
        public MaxDistanceRms {
            if (!(metres > 0 && Double.isFinite(metres))) {
                throw new IllegalArgumentException("a distance error must be positive: " + metres);
            }
        }

        @Override
        public <R> R match(ConditionCases<R> cases) {
            return cases.maxDistanceRms.apply(this);
        }

        @Override
        public Optional<String> unmet(RunFacts facts) {
            return facts.distanceRms().orElse(Double.POSITIVE_INFINITY) <= metres
                    ? Optional.empty()
                    : Condition.expected(
                            "a distance error of at most " + DecimalText.format(metres) + " m RMS",
                            Condition.describe(
                                    facts.distanceRms().orElse(Double.NaN),
                                    metres,
                                    RMS_DECIMALS,
                                    "no straight wall was followed"));
        }
    }

    /**
     * A state that the controller must pass through.
     *
     * @param state the state
     */
    public record VisitedState(ControllerState state) implements Condition {

        @Override
        public <R> R match(ConditionCases<R> cases) {
            return cases.visitedState.apply(this);
        }

        @Override
        public Optional<String> unmet(RunFacts facts) {
            return facts.visitedStates().contains(state)
                    ? Optional.empty()
                    : Condition.expected("the state " + state, "it was never reached; passed: " + facts.visitedNames());
        }
    }

    /**
     * The state that the controller must end in.
     *
     * @param state the state
     */
    public record FinalState(ControllerState state) implements Condition {

        @Override
        public <R> R match(ConditionCases<R> cases) {
            return cases.finalState.apply(this);
        }

        @Override
        public Optional<String> unmet(RunFacts facts) {
            return state.equals(facts.finalState())
                    ? Optional.empty()
                    : Condition.expected("the final state " + state, "it is " + facts.finalState());
        }
    }
}
