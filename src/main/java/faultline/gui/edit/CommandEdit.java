package faultline.gui.edit;

import faultline.gui.document.LaterChange;
import faultline.gui.document.SensorRename;
import faultline.gui.document.TimelineEvents;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.LongFunction;

/** An edit made by commands. All commands of one gesture form one edit. */
final class CommandEdit implements Edit {

    private final int gestureId;
    private final Map<EditTarget, CommandResult> results = new LinkedHashMap<>();
    private boolean ahead;
    /** Whether the run has the edit from its start, because it was made in an earlier one. */
    private boolean fromStart;

    /** Creates an edit of executed commands. */
    CommandEdit(int gestureId, List<CommandResult> results) {
        this.gestureId = gestureId;
        results.forEach(this::add);
    }

    private void add(CommandResult result) {
        results.merge(
                EditTarget.of(result.command()),
                result,
                (earlier, later) -> new CommandResult.Executed(later.tick(), later.command(), earlier.inverse()));
    }

    /**
     * Adds the commands of a newer edit if it belongs to the same gesture; returns whether it does. A key that is
     * pressed during a drag is an edit of its own if it switches a sensor or injects a fault, because such events are
     * undone on the timeline in a later run.
     */
    boolean merge(CommandEdit newer) {
        boolean sameGesture = newer.gestureId == gestureId && newer.hasOnlyEvents() == hasOnlyEvents();
        if (sameGesture) {
            newer.results.values().forEach(this::add);
        }
        return sameGesture;
    }

    /** Changes the id of a sensor in the commands and in what undoes them. */
    void rename(SensorRename rename) {
        List<CommandResult> before = results();
        results.clear();
        before.stream().map(rename::rename).forEach(this::add);
    }

    /** Returns whether the edit restores what it changed, such as a cancelled drag. */
    boolean isNoOp() {
        return results.values().stream().allMatch(CommandResult::isNoOp);
    }

    /** Returns whether all commands belong to a time of the run. */
    boolean hasOnlyEvents() {
        return results.values().stream().map(CommandResult::command).allMatch(TimelineEvents::isEvent);
    }

    /** Returns the results of the commands when they were executed for the first time. */
    List<CommandResult> results() {
        return List.copyOf(results.values());
    }

    /** Returns whether the edit is undone only because the run stands at an earlier tick. */
    boolean isAhead() {
        return ahead;
    }

    void setAhead(boolean newAhead) {
        ahead = newAhead;
    }

    boolean isFromStart() {
        return fromStart;
    }

    /** Sets whether the edit is part of a new run from its start. */
    void setFromStart(boolean newFromStart) {
        fromStart = newFromStart;
    }

    /**
     * Returns the changes that undo the edit, given the results of its last and of its first execution, what returns
     * the commands of the timeline since a tick, and what returns those since the result of a command that changes the
     * setup.
     */
    List<LaterChange> undoChanges(
            List<CommandResult> executed,
            List<CommandResult> firsts,
            LongFunction<List<Command>> plannedSince,
            Function<CommandResult, List<Command>> plannedAfter) {
        Map<EditTarget, CommandResult> first = new HashMap<>();
        firsts.forEach(result -> first.putIfAbsent(EditTarget.of(result.command()), result));
        List<CommandResult> backwards = new ArrayList<>(executed);
        Collections.reverse(backwards);
        return backwards.stream()
                .flatMap(result -> undo(
                        result, first.getOrDefault(EditTarget.of(result.command()), result), plannedSince, plannedAfter)
                        .stream())
                .toList();
    }

    private static List<LaterChange> undo(
            CommandResult result,
            CommandResult first,
            LongFunction<List<Command>> plannedSince,
            Function<CommandResult, List<Command>> plannedAfter) {
        if (TimelineEvents.isEvent(result.command())) {
            return same(TimelineEvents.undo(result, plannedSince.apply(result.tick())));
        }
        return first.inverse().size() == 1
                ? LaterChange.after(plannedAfter.apply(first), inverse(first))
                        .map(List::of)
                        .orElseGet(() -> same(result.inverse()))
                : same(result.inverse());
    }

    private static CommandResult inverse(CommandResult result) {
        return new CommandResult.Executed(result.tick(), result.inverse().get(0), List.of(result.command()));
    }

    private static List<LaterChange> same(List<Command> commands) {
        return commands.stream().map(LaterChange::same).toList();
    }

    /** Returns the changes that redo the edit, given what returns the commands of the timeline since a result. */
    List<LaterChange> redoChanges(Function<CommandResult, List<Command>> plannedAfter) {
        return results.values().stream()
                .map(result -> redo(result, plannedAfter))
                .toList();
    }

    private static LaterChange redo(CommandResult result, Function<CommandResult, List<Command>> plannedAfter) {
        return TimelineEvents.isEvent(result.command()) || result.inverse().size() != 1
                ? LaterChange.same(result.command())
                : LaterChange.after(plannedAfter.apply(result), result)
                        .orElseGet(() -> LaterChange.same(result.command()));
    }

    @Override
    public String name() {
        return EditNames.nameOf(results());
    }

    @Override
    public void apply(UndoController controller, boolean redone) {
        controller.submit(this, redone);
    }
}
