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
 * executed for the last edit before that changed the same switch or faults. Without one, they count as executed for the
 * first edit after them: if it was executed at the tick of the undo, both have cancelled out and the event of the
 * undone edit is in effect.
 */
final class ExecutedEvents {

    private final Map<Edit, List<CommandResult>> events = new IdentityHashMap<>();
    private final Map<Object, Edit> lastEdits = new HashMap<>();
    /** Events without an edit before them, by what they change. */
    private final Map<Object, List<CommandResult>> waiting = new HashMap<>();

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
        executed.forEach(result -> add(edit, result));
    }

    /** Adds one event, and returns whether it counts as executed for another edit. */
    boolean add(CommandEdit edit, CommandResult result, Edit other) {
        int before = count(other);
        add(edit, result);
        return count(other) > before;
    }

    private void add(CommandEdit edit, CommandResult result) {
        Object subject = subject(result);
        if (events.containsKey(edit)) {
            lastEdits.put(subject, edit);
            events.get(edit).addAll(waiting.getOrDefault(subject, List.of()));
            waiting.remove(subject);
        }
        Edit owner = lastEdits.get(subject);
        (owner == null ? waiting.computeIfAbsent(subject, none -> new ArrayList<>()) : events.get(owner)).add(result);
    }

    /**
     * Returns what was executed for an edit, without events of one tick that cancel out, which the timeline lacks;
     * empty for an edit of other commands, or that is not done.
     */
    List<CommandResult> of(Edit edit) {
        return TimelineEvents.in(events.getOrDefault(edit, List.of()));
    }

    /** Returns the number of events that were executed for an edit, also of those that cancel out. */
    int count(Edit edit) {
        return events.getOrDefault(edit, List.of()).size();
    }
}
