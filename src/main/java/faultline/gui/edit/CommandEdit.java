package faultline.gui.edit;

import faultline.world.Command;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.swing.undo.AbstractUndoableEdit;
import javax.swing.undo.UndoableEdit;

/** One edit of the world. Edits of one gesture become one: its first state comes back with undo, its last with redo. */
final class CommandEdit extends AbstractUndoableEdit {

    private final int gestureId;
    private final transient Map<Object, ReversibleCommand> steps = new LinkedHashMap<>();
    private final transient Sender sender;
    private boolean ahead;

    /** Brings undone and redone edits to the run. */
    @FunctionalInterface
    interface Sender {

        /** Sends an edit's commands: those that do it, or those that take it back. */
        void send(CommandEdit edit, boolean done, List<Command> commands);
    }

    CommandEdit(int gesture, List<ReversibleCommand> steps, Sender sender) {
        this.gestureId = gesture;
        this.sender = sender;
        steps.forEach(this::add);
    }

    private void add(ReversibleCommand step) {
        steps.merge(step.target(), step, ReversibleCommand::mergedWith);
    }

    /** Whether the world is as it was before, such as after a drag that was cancelled. */
    boolean isNoOp() {
        return steps.values().stream().allMatch(ReversibleCommand::isNoOp);
    }

    /** Whether it is undone only because the run stands at a moment before it. */
    boolean isAhead() {
        return ahead;
    }

    void setAhead(boolean newLater) {
        ahead = newLater;
    }

    @Override
    public boolean addEdit(UndoableEdit newer) {
        boolean same = newer instanceof CommandEdit edit && edit.gestureId == gestureId;
        if (same) {
            ((CommandEdit) newer).steps.values().forEach(this::add);
        }
        return same;
    }

    @Override
    public void undo() {
        super.undo();
        ahead = false;
        List<ReversibleCommand> backwards = new ArrayList<>(steps.values());
        Collections.reverse(backwards);
        sender.send(
                this,
                false,
                backwards.stream().flatMap(step -> step.undo().stream()).toList());
    }

    @Override
    public void redo() {
        super.redo();
        ahead = false;
        sender.send(
                this, true, steps.values().stream().map(ReversibleCommand::redo).toList());
    }

    /** It may be kept though the history drops it: see {@link EditHistory}. */
    @Override
    public void die() {
        // There is nothing to let go.
    }

    @Override
    public String getPresentationName() {
        return EditNames.nameOf(List.copyOf(steps.values()));
    }
}
