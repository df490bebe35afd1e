package faultline.gui.edit;

import faultline.gui.change.Rename;
import faultline.gui.change.SensorReference;
import faultline.gui.change.TimelineEvents;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiFunction;

/**
 * What was executed in a run for the edits of events that are done. An event of another edit, which has been undone,
 * and the one that undid it, change nothing together, but only as long as the edit before them is done: they count as
 * executed for the last edit before that changed the same switch or faults. Without one, they count as executed for the
 * first edit after them: if it was executed at the tick of the undo, both have cancelled out and the event of the
 * undone edit is in effect.
 */
final class ExecutedEvents {

    private final BiFunction<Edit, CommandResult, CommandResult> named;
    private final Map<Edit, List<OwnedEvent>> events = new IdentityHashMap<>();
    /** All events with the ids that their sensors have now, in the order of execution. */
    private final List<CommandResult> all = new ArrayList<>();
    /** Those of all events that the timeline has; null until they are asked for after the last one was added. */
    private Set<CommandResult> onTimeline;

    private final Map<Object, Owner> owners = new HashMap<>();
    /** Events without an edit before them, by what they change. */
    private final Map<Object, List<CommandResult>> waiting = new HashMap<>();

    /** An event with the id that its sensor has now, and as the edit that owns it would have executed it. */
    private record OwnedEvent(CommandResult named, CommandResult event) {}

    /** An edit that is done, and one of its commands, which has the id that the sensor had when the edit was made. */
    private record Owner(Edit edit, Command command) {
        /** Returns an event about the same sensor with the id that the edit has for it. */
        CommandResult named(CommandResult event) {
            return SensorReference.in(event.command())
                    .map(id -> Rename.ofSensor(id, SensorReference.in(command).orElseThrow()))
                    .map(rename -> rename.rename(event))
                    .orElse(event);
        }
    }

    /** Takes the edits that are done, and what gives an event of an edit the id that its sensor has now. */
    ExecutedEvents(Collection<Edit> done, BiFunction<Edit, CommandResult, CommandResult> named) {
        this.named = named;
        for (Edit edit : done) {
            if (edit instanceof EventEdit earlier) {
                events.put(edit, new ArrayList<>());
                earlier.edit()
                        .results()
                        .forEach(result ->
                                owners.put(subjectOf(named.apply(edit, result)), new Owner(edit, result.command())));
            } else if (edit instanceof CommandEdit commands && commands.hasOnlyEvents()) {
                events.put(edit, new ArrayList<>());
            }
        }
    }

    private static Object subjectOf(CommandResult namedResult) {
        return TimelineEvents.subject(namedResult.command());
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
        CommandResult namedResult = named.apply(edit, result);
        all.add(namedResult);
        onTimeline = null;
        Object subject = subjectOf(namedResult);
        if (events.containsKey(edit)) {
            Owner owner = new Owner(edit, result.command());
            if (namedResult.isNoOp()) {
                // A redo without an effect has changed nothing before others.
                addTo(owner, namedResult);
                return;
            }
            owners.put(subject, owner);
            waiting.getOrDefault(subject, List.of()).forEach(earlier -> addTo(owners.get(subject), earlier));
            waiting.remove(subject);
        }
        if (owners.containsKey(subject)) {
            addTo(owners.get(subject), namedResult);
        } else {
            waiting.computeIfAbsent(subject, none -> new ArrayList<>()).add(namedResult);
        }
    }

    private void addTo(Owner owner, CommandResult namedResult) {
        events.get(owner.edit()).add(new OwnedEvent(namedResult, owner.named(namedResult)));
    }

    /**
     * Returns what was executed for an edit, without events of one tick that cancel out, also with those of others,
     * because the timeline lacks them; empty for an edit of other commands, or that is not done.
     */
    List<CommandResult> of(Edit edit) {
        if (onTimeline == null) {
            onTimeline = Collections.newSetFromMap(new IdentityHashMap<>());
            onTimeline.addAll(TimelineEvents.in(all));
        }
        return events.getOrDefault(edit, List.of()).stream()
                .filter(owned -> onTimeline.contains(owned.named()))
                .map(OwnedEvent::event)
                .toList();
    }

    /** Returns the number of events that were executed for an edit, also of those that cancel out. */
    int count(Edit edit) {
        return events.getOrDefault(edit, List.of()).size();
    }
}
