package faultline.gui.edit;

import faultline.gui.document.TimelineEvents;
import faultline.world.CommandResult;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/**
 * What was executed in a run for the edits of events that are done. An event of another edit, which has been undone,
 * and the one that undid it, change nothing together, but only as long as the edit before them is done: they count as
 * executed for the last edit before that changed the same switch or faults.
 */
final class ExecutedEvents {

    private final Map<Edit, List<CommandResult>> events = new IdentityHashMap<>();
    private final Map<Object, Edit> lastEdits = new HashMap<>();

    /** Takes the edits that are done. */
    ExecutedEvents(Collection<Edit> done) {
        for (Edit edit : done) {
            if (edit instanceof EventEdit earlier) {
                events.put(edit, new ArrayList<>());
                earlier.edit().results().forEach(result -> lastEdits.put(subject(result), edit));
            } else if (edit instanceof CommandEdit commands && commands.hasOnlyEvents()) {
                events.put(edit, new ArrayList<>());
            }
        }
    }

    private static Object subject(CommandResult result) {
        return TimelineEvents.subject(result.command());
    }

    /** Adds what was executed when an edit was done, undone or redone; must be called in the order of execution. */
    void add(CommandEdit edit, List<CommandResult> executed) {
        for (CommandResult result : executed) {
            if (events.containsKey(edit)) {
                lastEdits.put(subject(result), edit);
            }
            Edit owner = lastEdits.get(subject(result));
            if (owner != null) {
                events.get(owner).add(result);
            }
        }
    }

    /** Returns what was executed for an edit; empty for one of other commands, or that is not done. */
    List<CommandResult> of(Edit edit) {
        return events.getOrDefault(edit, List.of());
    }
}
