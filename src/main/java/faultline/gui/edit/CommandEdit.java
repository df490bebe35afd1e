package faultline.gui.edit;

import faultline.world.Command;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import javax.swing.undo.AbstractUndoableEdit;
import javax.swing.undo.UndoableEdit;

/** One edit of the world. Edits of one gesture become one: its first state comes back with undo, its last with redo. */
final class CommandEdit extends AbstractUndoableEdit {

    private final int gesture;
    private final transient Map<Object, Step> steps = new LinkedHashMap<>();
    private final transient Consumer<List<Command>> sender;

    CommandEdit(int gesture, List<Step> steps, Consumer<List<Command>> sender) {
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

    @Override
    public boolean addEdit(UndoableEdit later) {
        boolean same = later instanceof CommandEdit edit && edit.gesture == gesture;
        if (same) {
            ((CommandEdit) later).steps.values().forEach(this::add);
        }
        return same;
    }

    @Override
    public void undo() {
        super.undo();
        List<Step> backwards = new ArrayList<>(steps.values());
        Collections.reverse(backwards);
        sender.accept(backwards.stream().flatMap(step -> step.undo().stream()).toList());
    }

    @Override
    public void redo() {
        super.redo();
        sender.accept(steps.values().stream().map(Step::redo).toList());
    }

    @Override
    public String getPresentationName() {
        return EditNames.of(List.copyOf(steps.values()));
    }
}
