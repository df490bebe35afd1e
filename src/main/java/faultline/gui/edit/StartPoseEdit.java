package faultline.gui.edit;

import faultline.geometry.Pose;
import faultline.gui.text.Messages;
import java.util.function.Consumer;
import javax.swing.undo.AbstractUndoableEdit;

/** The robot's start was moved; undoing it begins the run anew. */
public final class StartPoseEdit extends AbstractUndoableEdit {

    private final transient Pose before;
    private final transient Pose after;
    private final transient Consumer<Pose> restarter;

    public StartPoseEdit(Pose before, Pose after, Consumer<Pose> starter) {
        this.before = before;
        this.after = after;
        this.restarter = starter;
    }

    @Override
    public void undo() {
        super.undo();
        restarter.accept(before);
    }

    @Override
    public void redo() {
        super.redo();
        restarter.accept(after);
    }

    @Override
    public String getPresentationName() {
        return Messages.get("edit.start");
    }
}
