package faultline.gui.edit;

import faultline.world.Command;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** An edit made by commands. All commands of one gesture form one edit. */
final class CommandEdit implements Edit {

    private final int gestureId;
    private final Map<EditTarget, ReversibleCommand> steps = new LinkedHashMap<>();
    private boolean ahead;

    CommandEdit(int gestureId, List<ReversibleCommand> steps) {
        this.gestureId = gestureId;
        steps.forEach(this::add);
    }

    private void add(ReversibleCommand step) {
        steps.merge(step.target(), step, ReversibleCommand::mergedWith);
    }

    /** Adds the commands of a newer edit if it belongs to the same gesture; returns whether it does. */
    boolean merge(CommandEdit newer) {
        boolean sameGesture = newer.gestureId == gestureId;
        if (sameGesture) {
            newer.steps.values().forEach(this::add);
        }
        return sameGesture;
    }

    /** Returns whether the edit restores what it changed, such as a cancelled drag. */
    boolean isNoOp() {
        return steps.values().stream().allMatch(ReversibleCommand::isNoOp);
    }

    /** Returns whether the edit is undone only because the run stands at an earlier tick. */
    boolean isAhead() {
        return ahead;
    }

    void setAhead(boolean newAhead) {
        ahead = newAhead;
    }

    List<Command> undoCommands() {
        List<ReversibleCommand> backwards = new ArrayList<>(steps.values());
        Collections.reverse(backwards);
        return backwards.stream().flatMap(step -> step.undo().stream()).toList();
    }

    List<Command> redoCommands() {
        return steps.values().stream().map(ReversibleCommand::redo).toList();
    }

    @Override
    public String name() {
        return EditNames.nameOf(List.copyOf(steps.values()));
    }
}
