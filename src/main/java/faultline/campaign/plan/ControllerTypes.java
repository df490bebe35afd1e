package faultline.campaign.plan;

import faultline.external.ControllerNames;
import faultline.scenario.ControllerElement;
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
            List<String> own = common.isEmpty() ? List.of(typeIn(world)) : common;
            List<String> varied = new ArrayList<>();
            // At most one factor sets the type.
            factors.stream()
                    .map(Factor::levels)
                    .filter(levels -> levels.stream()
                            .anyMatch(level -> !typesIn(level.edits()).isEmpty()))
                    .flatMap(List::stream)
                    .map(level -> typesIn(level.edits()))
                    .forEach(set -> varied.addAll(set.isEmpty() ? own : set));
            types.addAll(varied.isEmpty() ? own : varied);
        }
        return List.copyOf(types);
    }

    private static String typeIn(WorldSource world) {
        return world.root(0)
                .firstChild("controller")
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
     * Returns a changed scenario without what its file says about a controller of another type than the changes set. A
     * plan can thus set the type in scenarios whose files have attributes of their own type. What the plan sets stays.
     */
    static XmlElement withoutEarlierType(
            XmlElement original, XmlElement changed, List<ScenarioChange> constants, List<ScenarioChange> edits) {
        Optional<XmlElement> before = original.firstChild("controller");
        if (before.isEmpty() || typesIn(edits).isEmpty()) {
            return changed;
        }
        Set<String> kept = Stream.concat(constants.stream(), edits.stream())
                .flatMap(ControllerTypes::setByPlan)
                .collect(Collectors.toSet());
        List<XmlElement> children = changed.children().stream()
                .map(child -> child.name().equals("controller")
                        ? ControllerElement.withoutEarlierType(before.get(), child, kept)
                        : child)
                .toList();
        return new XmlElement(changed.name(), changed.location(), changed.attributes(), children, changed.text());
    }

    /** Returns the name of the attribute or of the child of the controller that a change sets, if it sets one. */
    private static Stream<String> setByPlan(ScenarioChange change) {
        if (!(change instanceof ScenarioChange.SetAttribute set)) {
            return Stream.of();
        }
        List<AttributePath.PathStep> steps = set.path().steps();
        boolean ofController = !steps.isEmpty() && steps.get(0).element().equals("controller");
        return ofController
                ? Stream.of(
                        steps.size() == 1
                                ? set.path().attribute()
                                : steps.get(1).element())
                : Stream.of();
    }
}
