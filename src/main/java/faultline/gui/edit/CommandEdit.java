package faultline.gui.edit;

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

/** An edit made by commands. All commands of one gesture form one edit. */
final class CommandEdit implements Edit {

    private final int gestureId;
    private final Map<EditTarget, CommandResult> results = new LinkedHashMap<>();
    private boolean ahead;

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

    /** Returns the commands that undo executed ones, given what returns the commands of the timeline since a tick. */
    static List<Command> undoCommands(List<CommandResult> executed, LongFunction<List<Command>> plannedSince) {
        List<CommandResult> backwards = new ArrayList<>(executed);
        Collections.reverse(backwards);
        return backwards.stream()
                .flatMap(result -> undo(result, plannedSince).stream())
                .toList();
    }

    private static List<Command> undo(CommandResult result, LongFunction<List<Command>> plannedSince) {
        return TimelineEvents.isEvent(result.command())
                ? TimelineEvents.undo(result, plannedSince.apply(result.tick()))
                : result.inverse();
    }

    /** Returns the commands that redo the edit. */
    List<Command> redoCommands() {
        return results.values().stream().map(CommandResult::command).toList();
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
