package faultline.scenario;

import faultline.control.ControllerSpec;
import faultline.control.FollowerState;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** Makes the expectations of their element. */
final class ExpectReader {

    /** More than any controller has. */
    private static final int MOST_STATES = 50;

    private final Complaints complaints;
    private final List<String> possible;

    ExpectReader(Complaints complaints, ControllerSpec controller) {
        this.complaints = complaints;
        this.possible = statesOf(controller);
    }

    private static List<String> statesOf(ControllerSpec controller) {
        return controller instanceof ControllerSpec.WallFollowing ? Arrays.stream(FollowerState.values()).map(Enum::name).toList()
                : List.of(controller.firstState());
    }

    Expectation read(Node node) {
        Content.check(node, List.of(), complaints);
        Fields fields = new Fields(node, complaints);
        Optional<Boolean> collision = fields.has("collision") ? Optional.of(fields.flag("collision")) : Optional.empty();
        OptionalDouble coverage = optional(fields, "minCoverage", Range.SHARE);
        OptionalDouble distance = optional(fields, "maxDistanceRms", Range.SIZE);
        List<String> states = new ArrayList<>();
        fields.text("states").ifPresent(text -> states.addAll(states(fields, text)));
        Optional<String> last = fields.text("finalState").map(String::strip);
        last.ifPresent(state -> check(fields, "finalState", state));
        fields.done();
        return new Expectation(collision, coverage, distance, states, last);
    }

    private static OptionalDouble optional(Fields fields, String name, Range range) {
        return fields.has(name) ? OptionalDouble.of(fields.number(name, range)) : OptionalDouble.empty();
    }

    private List<String> states(Fields fields, String text) {
        List<String> states = Arrays.asList(text.strip().split("\\s+", MOST_STATES));
        states.forEach(state -> check(fields, "states", state));
        return states;
    }

    private void check(Fields fields, String name, String state) {
        if (!possible.contains(state)) {
            fields.complain(name, state, "one of the controller's states: " + Quoting.list(possible) + Spelling.hint(state, possible));
        }
    }
}
