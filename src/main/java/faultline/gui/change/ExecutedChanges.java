package faultline.gui.change;

import faultline.engine.SimulationSetup;
import faultline.world.CommandResult;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * The changes of a run in the order of their ticks, and how many of them the run has executed: when it is moved to an
 * earlier tick, the later changes remain until it executes another command there. Those that are events may have
 * another effect in the present run than when they were executed, or none.
 */
final class ExecutedChanges {

    private final List<ExecutedChange> changes = new ArrayList<>();

    /** The number of changes that the run has executed. */
    private int position;

    /** Null if the changes are others than when it was made. */
    private EventIndex eventIndex;

    /** Returns all changes, including those that the run has not executed yet. */
    List<ExecutedChange> all() {
        return Collections.unmodifiableList(changes);
    }

    /** Returns the changes that the run has executed. */
    List<ExecutedChange> executed() {
        return all().subList(0, position);
    }

    /** Returns the changes that the run has not executed. */
    List<ExecutedChange> later() {
        return all().subList(position, changes.size());
    }

    /** Adds the changes of another run that are accepted, in their order. Those that it has executed are executed. */
    void addFrom(ExecutedChanges others, Predicate<ExecutedChange> accepted) {
        others.executed().stream().filter(accepted).forEach(changes::add);
        position = changes.size();
        others.later().stream().filter(accepted).forEach(changes::add);
        eventIndex = null;
    }

    /**
     * Adds a change that the run has executed now. Removes the later changes if the run has executed a command for it;
     * otherwise those that undo or redo the same change without the run. Events without an effect remain.
     *
     * @return whether there were no later changes
     */
    boolean execute(ExecutedChange change) {
        eventIndex = null;
        moveTo(change.tick() - 1, position);
        boolean last = position == changes.size();
        changes.subList(position, changes.size())
                .removeIf(later -> !later.isEventWithoutEffectNow()
                        && (change.executed() != null || later.isWithoutRun(change.change())));
        changes.add(position, change);
        position++;
        return last;
    }

    /** Drops the events later than a tick that change nothing any more. */
    void dropEventsWithoutEffectAfter(long tick) {
        eventIndex = null;
        changes.subList(position, changes.size())
                .removeIf(later -> later.tick() > tick && later.isEventWithoutEffectNow());
    }

    /** Follows the run to a tick. It has executed the changes up to that tick. */
    void moveTo(long tick) {
        moveTo(tick, 0);
    }

    private void moveTo(long tick, int from) {
        position = from;
        while (position < changes.size() && changes.get(position).tick() <= tick) {
            position++;
        }
    }

    /** Returns the events that change something, without those of one tick that cancel each other. */
    List<CommandResult> events() {
        return TimelineEvents.in(changes.stream().map(ExecutedChange::change).toList());
    }

    /** Returns the events that change nothing any more, to be compared by identity. */
    Set<CommandResult> eventsWithoutEffectNow() {
        Set<CommandResult> events = Collections.newSetFromMap(new IdentityHashMap<>());
        changes.stream()
                .filter(ExecutedChange::isEventWithoutEffectNow)
                .map(ExecutedChange::change)
                .forEach(events::add);
        return events;
    }

    /** Returns whether events, with or without an effect, are later than a tick. */
    boolean hasEventsAfter(long tick) {
        return Stream.concat(events().stream(), eventsWithoutEffectNow().stream())
                .anyMatch(event -> event.tick() > tick);
    }

    /** Determines what undoes the events in a run of a setup with its timeline. */
    void updateEvents(SimulationSetup setup) {
        eventIndex = null;
        EventStates states = new EventStates(setup);
        changes.replaceAll(change -> change.isEvent() ? states.execute(change) : change);
    }

    /** Notes that the results of an undo, which are among these changes, undo events of the run. */
    void linkUndo(List<CommandResult> undone, List<CommandResult> results) {
        eventIndex = null;
        EventIndex.linkUndo(changes, undone, results);
    }

    /** Returns the result of an event that the run has executed, with what undoes it in the present run. */
    CommandResult presentResult(CommandResult event) {
        if (eventIndex == null) {
            eventIndex = new EventIndex(changes);
        }
        return eventIndex.present(event);
    }

    /** Returns these changes with another id of a sensor or an obstacle. */
    ExecutedChanges renamed(Rename rename) {
        ExecutedChanges result = new ExecutedChanges();
        changes.stream().map(change -> change.renamed(rename)).forEach(result.changes::add);
        result.position = position;
        return result;
    }
}
