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

    private final int gesture;
    private final transient Map<Object, Step> steps = new LinkedHashMap<>();
    private final transient Sender sender;
    private boolean later;

    /** Brings undone and redone edits to the run. */
    @FunctionalInterface
    interface Sender {

        /** Sends an edit's commands: those that do it, or those that take it back. */
        void send(CommandEdit edit, boolean done, List<Command> commands);
    }

    CommandEdit(int gesture, List<Step> steps, Sender sender) {
        this.gesture = gesture;
        this.sender = sender;
        steps.forEach(this::add);
    }

    private void add(Step step) {
        steps.merge(step.about(), step, Step::then);
    }

    /** Whether the world is as it was before, such as after a drag that was cancelled. */
    boolean isNothing() {
        return steps.values().stream().allMatch(Step::isNothing);
    }

    /** Whether it is undone only because the run stands at a moment before it. */
    boolean isLater() {
        return later;
    }

    void setLater(boolean newLater) {
        later = newLater;
    }

    @Override
    public boolean addEdit(UndoableEdit newer) {
        boolean same = newer instanceof CommandEdit edit && edit.gesture == gesture;
        if (same) {
            ((CommandEdit) newer).steps.values().forEach(this::add);
        }
        return same;
    }

    @Override
    public void undo() {
        super.undo();
        later = false;
        List<Step> backwards = new ArrayList<>(steps.values());
        Collections.reverse(backwards);
        sender.send(this, false, backwards.stream().flatMap(step -> step.undo().stream()).toList());
    }

    @Override
    public void redo() {
        super.redo();
        later = false;
        sender.send(this, true, steps.values().stream().map(Step::redo).toList());
    }

    /** It may be kept though the history drops it: see {@link EditHistory}. */
    @Override
    public void die() {
        // There is nothing to let go.
    }

    @Override
    public String getPresentationName() {
        return EditNames.of(List.copyOf(steps.values()));
    }
}
