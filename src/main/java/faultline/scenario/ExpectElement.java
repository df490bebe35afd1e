package faultline.scenario;

import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.engine.ControllerFactory;
import faultline.io.XmlText;
import faultline.scenario.xml.AttributeReader;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.XmlElement;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** An element of expectations in a file, the type of whose controller has been replaced. */
public final class ExpectElement {

    private ExpectElement() {}

    /**
     * {@return an element without expected states that no controller of its scenario has; the same if the controller is
     * not part of the program, whose states are not known}
     *
     * @param expect the element
     * @param root the scenario with the present type of its controller
     * @param kept the names of the attributes that stay in any case
     */
    public static XmlElement withPossibleStates(XmlElement expect, XmlElement root, Set<String> kept) {
        Set<String> possible =
                possibleStates(root).stream().map(ControllerState::name).collect(Collectors.toSet());
        if (possible.isEmpty()) {
            return expect;
        }
        Map<String, String> attributes = new LinkedHashMap<>(expect.attributes());
        Stream.of("states", "finalState")
                .filter(name -> !kept.contains(name))
                // A text without any of the states becomes null, which removes the attribute.
                .forEach(name -> attributes.computeIfPresent(name, (same, text) -> only(possible, text)));
        return new XmlElement(expect.name(), expect.location(), attributes, expect.children(), expect.text());
    }

    private static String only(Set<String> possible, String text) {
        String left = Arrays.stream(XmlText.strip(text).split("[ \\t\\n\\r]+"))
                .filter(possible::contains)
                .collect(Collectors.joining(" "));
        return left.isEmpty() ? null : left;
    }

    /**
     * Returns the states of all controllers of a scenario, those of the first one first, without reporting mistakes;
     * empty if the first one is not part of the program.
     */
    static List<ControllerState> possibleStates(XmlElement root) {
        Problems ignored = new Problems("");
        ControllerSpec first = root.firstChild("controller")
                .map(node -> ControllerReader.read(node, ignored))
                .orElse(ControllerSpec.WallFollowing.DEFAULT);
        if (!(first instanceof ControllerSpec.BuiltIn)) {
            return List.of();
        }
        Stream<ControllerSpec> later = root.childrenNamed("timeline")
                .flatMap(timeline -> timeline.childrenNamed("controller"))
                .map(node -> ControllerReader.readBuiltIn(
                        new AttributeReader(node, ignored), ControllerReader.defaultsFor(first)));
        return Stream.concat(Stream.of(first), later)
                .flatMap(controller -> ControllerFactory.states(controller).stream())
                .distinct()
                .toList();
    }
}
