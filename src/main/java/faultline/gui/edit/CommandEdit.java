package faultline.gui.edit;

import faultline.gui.document.LaterChange;
import faultline.gui.document.SensorRename;
import faultline.gui.document.TimelineEvents;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongFunction;
import java.util.stream.Stream;

/** An edit made by commands. All commands of one gesture form one edit. */
final class CommandEdit implements Edit {

    private final int gestureId;
    private final Map<EditTarget, CommandResult> results = new LinkedHashMap<>();
    private boolean ahead;
    /** Whether the edit was made in an earlier run. */
    private boolean earlier;

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

    /** Returns whether the edit was made in an earlier run and acts from the start: it is undone and redone there. */
    boolean actsFromStart() {
        return earlier && !hasOnlyEvents();
    }

    /** Follows the start of another run, given the results when the edit was first executed in the one before. */
    void runStarted(List<CommandResult> firsts) {
        earlier = true;
        firsts.forEach(result -> results.put(EditTarget.of(result.command()), result));
    }

    /**
     * Returns the changes that undo the edit, given the results of its last and of its first execution in this run, and
     * what returns the commands of the timeline since a tick.
     */
    List<LaterChange> undoChanges(
            List<CommandResult> executed, List<CommandResult> firsts, LongFunction<List<Command>> plannedSince) {
        return backwards(executed)
                .flatMap(result -> undo(result, first(firsts, result), plannedSince).stream())
                .toList();
    }

    private static Stream<CommandResult> backwards(List<CommandResult> results) {
        List<CommandResult> backwards = new ArrayList<>(results);
        Collections.reverse(backwards);
        return backwards.stream();
    }

    private static CommandResult first(List<CommandResult> firsts, CommandResult result) {
        EditTarget target = EditTarget.of(result.command());
        return firsts.stream()
                .filter(first -> EditTarget.of(first.command()).equals(target))
                .findFirst()
                .orElse(result);
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
        return new CommandResult.Executed(result.tick(), result.inverse().get(0), List.of(result.command()));
    }

    /** Returns the changes of the start that redo or undo the edit, which was made in an earlier run. */
    List<CommandResult> startChanges(boolean redone) {
        List<CommandResult> changes = results();
        return redone ? changes : backwards(changes).map(CommandEdit::inverse).toList();
    }

    private static List<LaterChange> same(List<Command> commands) {
        return commands.stream().map(LaterChange::same).toList();
    }

    /**
     * Returns the changes that redo the edit, given the results of its first execution in this run, and what returns
     * the commands of the timeline since a tick.
     */
    List<LaterChange> redoChanges(List<CommandResult> firsts, LongFunction<List<Command>> plannedSince) {
        return results.values().stream()
                .map(result -> redo(first(firsts, result), plannedSince))
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
        return EditNames.nameOf(results());
    }

    @Override
    public void apply(UndoController controller, boolean redone) {
        controller.submit(this, redone);
    }
}
