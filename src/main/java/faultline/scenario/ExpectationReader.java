package faultline.scenario;

import faultline.control.ControllerState;
import faultline.engine.metrics.Expectation;
import faultline.io.XmlText;
import faultline.scenario.xml.Allowed;
import faultline.scenario.xml.AttributeReader;
import faultline.scenario.xml.ElementRules;
import faultline.scenario.xml.NumberRange;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.ScenarioLimits;
import faultline.scenario.xml.XmlElement;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Reads the expectations. */
final class ExpectationReader {

    private final Problems problems;
    /** Empty if the controllers are not known, or not part of the program, which knows no states of them. */
    private final List<String> knownStates;

    ExpectationReader(Problems problems, List<ControllerState> knownStates) {
        this.problems = problems;
        this.knownStates = knownStates.stream().map(ControllerState::name).toList();
    }

    Expectation read(XmlElement node) {
        ElementRules.checkChildren(node, List.of(), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        List<Expectation.Condition> conditions = new ArrayList<>();
        if (fields.isPresent("collision")) {
            conditions.add(new Expectation.Collides(fields.flag("collision")));
        }
        if (fields.isPresent("minCoverage")) {
            conditions.add(new Expectation.MinCoverage(fields.number("minCoverage", NumberRange.FRACTION)));
        }
        if (fields.isPresent("maxDistanceRms")) {
            conditions.add(new Expectation.MaxDistanceRms(fields.number("maxDistanceRms", NumberRange.SIZE)));
        }
        fields.text("states", ScenarioLimits.MAX_STATES_LENGTH).ifPresent(text -> readStates(fields, text)
                .forEach(state -> conditions.add(new Expectation.VisitedState(state))));
        fields.text("finalState", ScenarioLimits.MAX_STATES_LENGTH)
                .ifPresent(name -> conditions.add(
                        new Expectation.FinalState(readState(fields, "finalState", XmlText.strip(name)))));
        fields.reportUnknownAndMissing();
        return new Expectation(conditions);
    }

    private List<ControllerState> readStates(AttributeReader fields, String text) {
        return Arrays.stream(XmlText.strip(text).split("[ \\t\\n\\r]+"))
                .map(state -> readState(fields, "states", state))
                .toList();
    }

    private ControllerState readState(AttributeReader fields, String name, String state) {
        if (!knownStates.isEmpty() && !knownStates.contains(state)) {
            fields.report(
                    name, state, Allowed.withHint(Allowed.STATES.with(Allowed.names(knownStates)), state, knownStates));
        }
        if (state.isEmpty() && knownStates.isEmpty()) {
            fields.report(name, state, Allowed.STATE.with());
        }
        return ControllerState.of(state);
    }
}
