package faultline.gui.window;

import faultline.geometry.Pose;
import faultline.gui.text.Texts;
import java.util.function.Consumer;
import javax.swing.undo.AbstractUndoableEdit;

/** The robot's start was moved; undoing it begins the run anew. */
final class StartEdit extends AbstractUndoableEdit {

    private final transient Pose before;
    private final transient Pose after;
    private final transient Consumer<Pose> starter;

    StartEdit(Pose before, Pose after, Consumer<Pose> starter) {
        this.before = before;
        this.after = after;
        this.starter = starter;
    }

    @Override
    public void undo() {
        super.undo();
        starter.accept(before);
    }

    @Override
    public void redo() {
        super.redo();
        starter.accept(after);
    }

    @Override
    public String getPresentationName() {
        return Texts.text("edit.start");
    }
}
