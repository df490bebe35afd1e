package faultline.campaign.plan;

import faultline.external.ControllerNames;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;

/** Finds the types of the controllers that drive the robots of a plan. */
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
}
