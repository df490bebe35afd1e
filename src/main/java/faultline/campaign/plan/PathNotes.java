package faultline.campaign.plan;

import faultline.io.Message;
import faultline.scenario.xml.Problem;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Finds the paths of a plan that lead to the first of several elements of a scenario because they name none of them.
 */
final class PathNotes {

    /** The number of paths, in all worlds together, after which no further world is searched. */
    private static final int MAX_PATHS = 200_000;

    private PathNotes() {}

    /** Returns a note on each such path, for the first world of the plan in which there are several elements. */
    static List<Problem> of(
            String file, List<WorldSource> worlds, List<ScenarioChange> constants, List<Factor> factors) {
        Map<AttributePath, ScenarioChange> unnamed = new LinkedHashMap<>();
        Stream.concat(
                        constants.stream(),
                        factors.stream()
                                .flatMap(factor -> factor.settingLevels().stream())
                                .flatMap(level -> level.edits().stream()))
                .forEach(change -> {
                    if (change instanceof ScenarioChange.SetAttribute set) {
                        unnamed.putIfAbsent(set.path(), set);
                    }
                });
        List<Problem> notes = new ArrayList<>();
        long searched = 0;
        for (WorldSource world : worlds) {
            searched += unnamed.size();
            if (unnamed.isEmpty() || searched > MAX_PATHS) {
                break;
            }
            ScenarioTree tree = new ScenarioTree(world.root(0));
            unnamed.entrySet().removeIf(entry -> {
                Optional<Message> note = tree.note(entry.getKey());
                note.ifPresent(text -> notes.add(new Problem(
                        file, entry.getValue().location(), PlanProblem.IN_WORLD.with(text, world.label(0)))));
                return note.isPresent();
            });
        }
        return notes;
    }
}
