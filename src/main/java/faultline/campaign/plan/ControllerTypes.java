package faultline.campaign.plan;

import faultline.external.ControllerNames;
import faultline.scenario.ControllerElement;
import faultline.scenario.ExpectElement;
import faultline.scenario.xml.XmlElement;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The types of the controllers that drive the robots of a plan. */
final class ControllerTypes {

    private ControllerTypes() {}

    /** Returns the types in the order of the worlds and of the levels, each once. */
    static List<String> of(Collection<WorldSource> worlds, List<ScenarioChange> constants, List<Factor> factors) {
        Set<String> types = new LinkedHashSet<>();
        for (WorldSource world : worlds) {
            List<String> common = typesIn(constants);
            List<String> own = common.isEmpty() ? List.of(typeIn(world.root(0))) : common;
            List<String> varied = new ArrayList<>();
            // At most one factor sets the type.
            factors.stream()
                    .filter(factor -> factor.settingLevels().stream()
                            .anyMatch(level -> !typesIn(level.edits()).isEmpty()))
                    .flatMap(factor -> factor.levels().stream())
                    .map(level -> typesIn(level.edits()))
                    .forEach(set -> varied.addAll(set.isEmpty() ? own : set));
            types.addAll(varied.isEmpty() ? own : varied);
        }
        return List.copyOf(types);
    }

    private static String typeIn(XmlElement root) {
        return root.firstChild("controller")
                .map(controller -> controller.attributes().get("type"))
                .map(String::strip)
                .filter(Predicate.not(String::isEmpty))
                .orElse(ControllerNames.WALL_FOLLOWER);
    }

    private static List<String> typesIn(List<ScenarioChange> changes) {
        return changes.stream()
                .filter(change -> change instanceof ScenarioChange.SetAttribute set
                        && set.path().isControllerType())
                .flatMap(change -> change.values().stream())
                .flatMap(ControllerTypes::texts)
                .toList();
    }

    private static Stream<String> texts(AttributeValue value) {
        return value.ranges().isEmpty()
                ? Stream.of(value.text((stream, block) -> 0, 0))
                : value.ranges().stream()
                        .flatMap(range ->
                                range instanceof DrawRange.Words choice ? choice.words().stream() : Stream.of());
    }

    /**
     * Returns a changed scenario without what its file says about a controller of another type than the changes set,
     * and without the states that it expects only of such a controller. A plan can thus set the type in scenarios whose
     * files have attributes of their own type. What the plan sets stays.
     */
    static XmlElement withoutEarlierType(
            XmlElement original, XmlElement changed, List<ScenarioChange> constants, List<ScenarioChange> edits) {
        if (typesIn(edits).isEmpty() || typeIn(original).equals(typeIn(changed))) {
            return changed;
        }
        List<ScenarioChange> changes =
                Stream.concat(constants.stream(), edits.stream()).toList();
        Optional<XmlElement> before = original.firstChild("controller");
        Set<String> keptOfController = setByPlan(changes, "controller");
        Set<String> keptOfExpect = setByPlan(changes, "expect");
        List<XmlElement> children = changed.children().stream()
                .map(child -> switch (child.name()) {
                    case "controller" ->
                        before.map(own -> ControllerElement.withoutEarlierType(own, child, keptOfController))
                                .orElse(child);
                    case "expect" -> ExpectElement.withPossibleStates(child, changed, keptOfExpect);
                    default -> child;
                })
                .toList();
        return new XmlElement(changed.name(), changed.location(), changed.attributes(), children, changed.text());
    }

    /** Returns the names of the attributes and of the children of a section that changes set. */
    private static Set<String> setByPlan(List<ScenarioChange> changes, String section) {
        return changes.stream()
                .flatMap(change -> setByPlan(change, section).stream())
                .collect(Collectors.toSet());
    }

    private static Optional<String> setByPlan(ScenarioChange change, String section) {
        if (!(change instanceof ScenarioChange.SetAttribute set)) {
            return Optional.empty();
        }
        List<AttributePath.PathStep> steps = set.path().steps();
        if (steps.isEmpty() || !steps.get(0).element().equals(section)) {
            return Optional.empty();
        }
        return Optional.of(
                steps.size() == 1 ? set.path().attribute() : steps.get(1).element());
    }
}
