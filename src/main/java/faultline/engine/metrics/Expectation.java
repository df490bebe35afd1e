package faultline.engine.metrics;

import faultline.control.ControllerState;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * What a scenario's run is expected to give; what is empty is not asked.
 *
 * @param collision whether the robot collides
 * @param minCoverage the least coverage, in [0, 1]
 * @param maxDistanceRms the greatest distance error on straight walls, metres, root mean square
 * @param states states that the controller must pass through, in any order
 * @param finalState the state that the controller must end in
 */
public record Expectation(
        Optional<Boolean> collision,
        OptionalDouble minCoverage,
        OptionalDouble maxDistanceRms,
        List<ControllerState> states,
        Optional<ControllerState> finalState) {

    /** Expects nothing. */
    public static final Expectation NONE = new Expectation(
            Optional.empty(), OptionalDouble.empty(), OptionalDouble.empty(), List.of(), Optional.empty());

    public Expectation {
        states = List.copyOf(states);
    }

    /**
     * What a run did not hold.
     *
     * @param result what the run came to
     * @return one sentence each, empty where all was held
     */
    public List<String> unmet(RunResult result) {
        return new ExpectationChecker(result).unmet(this);
    }
}
