package faultline.engine.metrics;

import faultline.control.ControllerState;
import faultline.io.DecimalText;
import faultline.world.Collision;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Collectors;

/** Holds one run's result against expectations, and puts into words what was not held. */
final class ExpectationChecker {

    private final RunResult result;
    private final List<String> unmet = new ArrayList<>();

    ExpectationChecker(RunResult result) {
        this.result = result;
    }

    List<String> unmet(Expectation expect) {
        expect.collision().ifPresent(this::checkCollision);
        expect.minCoverage().ifPresent(this::checkCoverage);
        expect.maxDistanceRms().ifPresent(this::checkDistance);
        expect.states().stream()
                .filter(state -> !result.visitedStates().contains(state))
                .forEach(state -> addUnmet(
                        "the state " + state,
                        "it was never reached; passed: "
                                + result.visitedStates().stream()
                                        .map(ControllerState::name)
                                        .collect(Collectors.joining(" "))));
        expect.finalState()
                .filter(state -> !state.equals(result.finalState()))
                .ifPresent(state -> addUnmet("the final state " + state, "it is " + result.finalState()));
        return List.copyOf(unmet);
    }

    private void checkCollision(boolean wanted) {
        if (wanted != result.collision().isPresent()) {
            addUnmet(
                    wanted ? "a collision" : "no collision",
                    result.collision().map(ExpectationChecker::describe).orElse("there was none"));
        }
    }

    private static String describe(Collision collision) {
        return "the robot struck " + collision.obstacle() + " at "
                + DecimalText.format(collision.point().x()) + ","
                + DecimalText.format(collision.point().y()) + " after " + DecimalText.format(collision.time()) + " s";
    }

    private void checkCoverage(double least) {
        if (!(result.coverage().orElse(0) >= least)) {
            addUnmet(
                    "a coverage of at least " + DecimalText.format(least),
                    describeValue(result.coverage(), "no wall was followed"));
        }
    }

    private void checkDistance(double most) {
        if (!(result.distanceRms().orElse(Double.POSITIVE_INFINITY) <= most)) {
            addUnmet(
                    "a distance error of at most " + DecimalText.format(most) + " m RMS",
                    describeValue(result.distanceRms(), "no straight wall was followed"));
        }
    }

    private static String describeValue(OptionalDouble value, String otherwise) {
        return value.isPresent() ? "it is " + DecimalText.format(value.getAsDouble()) : otherwise;
    }

    private void addUnmet(String wanted, String found) {
        unmet.add("expected " + wanted + ", but " + found);
    }
}
