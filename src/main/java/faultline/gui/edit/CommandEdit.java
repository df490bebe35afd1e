package faultline.gui.edit;

import faultline.gui.change.LaterChange;
import faultline.gui.change.ObstacleOrigins;
import faultline.gui.change.Rename;
import faultline.gui.change.TimelineEvents;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;
import java.util.function.LongFunction;

/** An edit made by commands. All commands of one gesture form one edit. */
final class CommandEdit implements Edit {

    private final int gestureId;
    /** What each part has changed since its first command, by the ticks of its commands. */
    private final Map<EditPart, NavigableMap<Long, CommandResult>> parts = new LinkedHashMap<>();

    private boolean ahead;
    /** Whether the edit was made in an earlier run. */
    private boolean earlier;

    /**
     * Commands with equal targets, up to where the timeline or a command with another target has changed the same
     * subject. The parts of a subject are numbered from 0.
     */
    private record EditPart(Object subject, int number) {}

    /** Creates an edit of executed commands. */
    CommandEdit(int gestureId, List<CommandResult> results) {
        this.gestureId = gestureId;
        results.forEach(result -> add(result, tick -> List.of()));
    }

    private void add(CommandResult result, LongFunction<List<Command>> plannedSince) {
        EditPart next = nextPart(parts, result);
        NavigableMap<Long, CommandResult> last = parts.get(new EditPart(next.subject(), next.number() - 1));
        if (last != null && continues(result, last(last), plannedSince)) {
            last.put(
                    result.tick(),
                    new CommandResult.Executed(
                            result.tick(),
                            result.command(),
                            result.effect(),
                            last(last).inverse()));
        } else {
            parts.put(next, new TreeMap<>(Map.of(result.tick(), result)));
        }
    }

    private static EditPart nextPart(Map<EditPart, ?> parts, CommandResult result) {
        Object subject = EditTarget.of(result.command()).subject();
        int number = 0;
        while (parts.containsKey(new EditPart(subject, number))) {
            number++;
        }
        return new EditPart(subject, number);
    }

    private static CommandResult last(NavigableMap<Long, CommandResult> results) {
        return results.lastEntry().getValue();
    }

    private static boolean continues(
            CommandResult result, CommandResult before, LongFunction<List<Command>> plannedSince) {
        return EditTarget.of(result.command()).equals(EditTarget.of(before.command()))
                && (result.inverse().equals(List.of(before.effect()))
                        || LaterChange.after(plannedSince.apply(before.tick()), before)
                                .isEmpty());
    }

    /**
     * Adds the commands of a newer edit if it belongs to the same gesture, given what returns the commands of the
     * timeline since a tick; returns whether it does. A key that is pressed during a drag is an edit of its own if it
     * switches a sensor or injects a fault, because such events are undone on the timeline in a later run.
     */
    boolean merge(CommandEdit newer, LongFunction<List<Command>> plannedSince) {
        boolean sameGesture = newer.gestureId == gestureId && newer.hasOnlyEvents() == hasOnlyEvents();
        if (sameGesture) {
            newer.results().forEach(result -> add(result, plannedSince));
        }
        return sameGesture;
    }

    /** Returns the tick of the last command. */
    long lastTick() {
        return results().stream().mapToLong(CommandResult::tick).max().orElse(0);
    }

    /** Drops the commands after a tick, which the run does not execute any more. */
    void cutAfter(long tick) {
        parts.values().forEach(results -> results.tailMap(tick, false).clear());
        parts.values().removeIf(Map::isEmpty);
    }

    /** Changes the id of a sensor in the commands and in what undoes them. */
    void rename(Rename rename) {
        List<NavigableMap<Long, CommandResult>> all = List.copyOf(parts.values());
        parts.clear();
        for (NavigableMap<Long, CommandResult> results : all) {
            results.replaceAll((tick, result) -> rename.rename(result));
            parts.put(nextPart(parts, last(results)), results);
        }
    }

    /** Returns the results of commands as those of parts, which are in the order of their numbers. */
    private static Map<EditPart, CommandResult> parts(List<CommandResult> results) {
        Map<EditPart, CommandResult> parts = new LinkedHashMap<>();
        results.forEach(result -> parts.put(nextPart(parts, result), result));
        return parts;
    }

    /** Returns whether the edit restores what it changed, such as a cancelled drag. */
    boolean isNoOp() {
        return results().stream().allMatch(CommandResult::isNoOp);
    }

    /** Returns whether all commands belong to a time of the run. */
    boolean hasOnlyEvents() {
        return results().stream().map(CommandResult::command).allMatch(TimelineEvents::isEvent);
    }

    /** Returns whether the edit can be undone while another one, which was made later in this run, stays done. */
    boolean isIndependentOf(CommandEdit newer) {
        return !actsFromStart() && Collections.disjoint(subjects(), newer.subjects());
    }

    /** Returns the ids of the obstacles that the edit changes, and the kinds of its other changes. */
    private List<String> subjects() {
        return results().stream()
                .map(CommandResult::command)
                .map(command -> ObstacleOrigins.subject(command)
                        .orElseGet(() -> EditTarget.of(command).kind()))
                .toList();
    }

    /** Returns the results of the commands when they were executed for the first time. */
    List<CommandResult> results() {
        return parts.values().stream().map(CommandEdit::last).toList();
    }

    /** Returns whether the edit is undone only because the run stands at an earlier tick. */
    boolean isAhead() {
        return ahead;
    }

    void setAhead(boolean newAhead) {
        ahead = newAhead;
    }

    /** Returns whether the edit was made in an earlier run and acts from the start: it is undone and redone there. */
    boolean actsFromStart() {
        return earlier && !hasOnlyEvents();
    }

    /** Follows the start of another run, given the results when the edit was first executed in the one before. */
    void runStarted(List<CommandResult> firsts) {
        earlier = true;
        parts(firsts).forEach((part, first) -> parts.put(part, new TreeMap<>(Map.of(first.tick(), first))));
    }

    /**
     * Returns the changes that undo the edit, given the results of its last and of its first execution in this run, and
     * what returns the commands of the timeline since a tick. They are in the reverse order, except that obstacles come
     * back in the order in which they were removed together: that is their drawing order.
     */
    List<LaterChange> undoChanges(
            List<CommandResult> executed, List<CommandResult> firsts, LongFunction<List<Command>> plannedSince) {
        Map<EditPart, CommandResult> firstParts = parts(firsts);
        // One block for each part or for parts that were removed one after another, the last block first.
        Deque<List<LaterChange>> blocks = new ArrayDeque<>();
        boolean afterRemoval = false;
        for (Map.Entry<EditPart, CommandResult> entry : parts(executed).entrySet()) {
            CommandResult result = entry.getValue();
            boolean removal = EditTarget.of(result.command()).kind().equals(EditTarget.REMOVAL);
            if (!removal || !afterRemoval) {
                blocks.addFirst(new ArrayList<>());
            }
            blocks.getFirst().addAll(undo(result, firstParts.getOrDefault(entry.getKey(), result), plannedSince));
            afterRemoval = removal;
        }
        return blocks.stream().flatMap(List::stream).toList();
    }

    private static List<LaterChange> undo(
            CommandResult result, CommandResult first, LongFunction<List<Command>> plannedSince) {
        if (TimelineEvents.isEvent(result.command())) {
            return same(TimelineEvents.undo(result, plannedSince.apply(result.tick())));
        }
        return first.inverse().size() == 1
                ? LaterChange.after(plannedSince.apply(first.tick()), inverse(first))
                        .map(List::of)
                        .orElseGet(() -> same(result.inverse()))
                : same(result.inverse());
    }

    private static CommandResult inverse(CommandResult result) {
        return new CommandResult.Executed(result.tick(), result.inverse().get(0), List.of(result.effect()));
    }

    /** Returns the changes of the start that redo or undo the edit, which was made in an earlier run. */
    List<CommandResult> startChanges(boolean redone) {
        List<CommandResult> changes = new ArrayList<>(results());
        if (!redone) {
            Collections.reverse(changes);
            changes.replaceAll(CommandEdit::inverse);
        }
        return changes;
    }

    private static List<LaterChange> same(List<Command> commands) {
        return commands.stream().map(LaterChange::same).toList();
    }

    /**
     * Returns the changes that redo the edit, given the results of its first execution in this run, and what returns
     * the commands of the timeline since a tick.
     */
    List<LaterChange> redoChanges(List<CommandResult> firsts, LongFunction<List<Command>> plannedSince) {
        Map<EditPart, CommandResult> firstParts = parts(firsts);
        return parts.entrySet().stream()
                .map(entry -> redo(firstParts.getOrDefault(entry.getKey(), last(entry.getValue())), plannedSince))
                .toList();
    }

    private static LaterChange redo(CommandResult first, LongFunction<List<Command>> plannedSince) {
        return TimelineEvents.isEvent(first.command()) || first.inverse().size() != 1
                ? LaterChange.same(first.command())
                : LaterChange.after(plannedSince.apply(first.tick()), first)
                        .orElseGet(() -> LaterChange.same(first.command()));
    }

    @Override
    public String name() {
        Map<EditTarget, CommandResult> named = new LinkedHashMap<>();
        results().forEach(result -> named.put(EditTarget.of(result.command()), result));
        return EditNames.nameOf(List.copyOf(named.values()));
    }

    @Override
    public void apply(UndoController controller, boolean redone) {
        controller.submit(this, redone);
    }
}
