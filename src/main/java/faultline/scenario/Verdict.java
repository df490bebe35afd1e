package faultline.scenario;

import faultline.engine.RunResult;
import faultline.world.Collision;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/** Holds one run's result against expectations, and puts into words what was not held. */
final class Verdict {

    private final RunResult result;
    private final List<String> unmet = new ArrayList<>();

    Verdict(RunResult result) {
        this.result = result;
    }

    List<String> unmet(Expectation expect) {
        expect.collision().ifPresent(this::collision);
        expect.minCoverage().ifPresent(this::coverage);
        expect.maxDistanceRms().ifPresent(this::distance);
        expect.states().stream().filter(state -> !result.states().contains(state))
                .forEach(state -> miss("the state " + state, "it was never reached; passed: " + String.join(" ", result.states())));
        expect.finalState().filter(state -> !state.equals(result.state())).ifPresent(state ->
                miss("the final state " + state, "it is " + result.state()));
        return List.copyOf(unmet);
    }

    private void collision(boolean wanted) {
        if (wanted != result.collision().isPresent()) {
            miss(wanted ? "a collision" : "no collision", result.collision().map(Verdict::words).orElse("there was none"));
        }
    }

    private static String words(Collision collision) {
        return "the robot struck " + collision.obstacle() + " at " + Numbers.toText(collision.point().x()) + ","
                + Numbers.toText(collision.point().y()) + " after " + Numbers.toText(collision.time()) + " s";
    }

    private void coverage(double least) {
        if (!(result.coverage().orElse(0) >= least)) {
            miss("a coverage of at least " + Numbers.toText(least), was(result.coverage(), "no wall was followed"));
        }
    }

    private void distance(double most) {
        if (!(result.distanceRms().orElse(Double.POSITIVE_INFINITY) <= most)) {
            miss("a distance error of at most " + Numbers.toText(most) + " m RMS", was(result.distanceRms(), "no straight wall was followed"));
        }
    }

    private static String was(OptionalDouble value, String otherwise) {
        return value.isPresent() ? "it is " + Numbers.toText(value.getAsDouble()) : otherwise;
    }

    private void miss(String wanted, String found) {
        unmet.add("expected " + wanted + ", but " + found);
    }
}
