package faultline.scenario.xml;

import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.engine.ControllerFactory;
import faultline.engine.metrics.Expectation;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** Makes the expectations of their element. */
final class ExpectationReader {

    /** More than any controller has. */
    private static final int MAX_STATES = 50;

    private final Problems problems;
    private final List<String> knownStates;

    ExpectationReader(Problems complaints, ControllerSpec controller) {
        this.problems = complaints;
        this.knownStates = ControllerFactory.states(controller).stream()
                .map(ControllerState::name)
                .toList();
    }

    Expectation read(XmlElement node) {
        ElementRules.checkChildren(node, List.of(), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        Optional<Boolean> collision =
                fields.isPresent("collision") ? Optional.of(fields.flag("collision")) : Optional.empty();
        OptionalDouble coverage = optionalNumber(fields, "minCoverage", NumberRange.FRACTION);
        OptionalDouble distance = optionalNumber(fields, "maxDistanceRms", NumberRange.SIZE);
        List<ControllerState> states = new ArrayList<>();
        fields.text("states").ifPresent(text -> states.addAll(readStates(fields, text)));
        Optional<ControllerState> last =
                fields.text("finalState").map(name -> readState(fields, "finalState", name.strip()));
        fields.reportUnknownAndMissing();
        return new Expectation(collision, coverage, distance, states, last);
    }

    private static OptionalDouble optionalNumber(AttributeReader fields, String name, NumberRange range) {
        return fields.isPresent(name) ? OptionalDouble.of(fields.number(name, range)) : OptionalDouble.empty();
    }

    private List<ControllerState> readStates(AttributeReader fields, String text) {
        return Arrays.stream(text.strip().split("\\s+", MAX_STATES))
                .map(state -> readState(fields, "states", state))
                .toList();
    }

    private ControllerState readState(AttributeReader fields, String name, String state) {
        if (!knownStates.contains(state)) {
            fields.report(
                    name, state, Allowed.withHint(Allowed.STATES.with(Allowed.names(knownStates)), state, knownStates));
        }
        return ControllerState.of(state);
    }
}
