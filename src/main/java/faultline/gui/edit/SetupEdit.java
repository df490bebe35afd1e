package faultline.gui.edit;

import java.util.function.Supplier;

/**
 * A change of the scenario's setup, named in the current language. Undoing it runs the scenario again with the old
 * setup. Edits of one gesture are merged.
 */
record SetupEdit(Supplier<String> nameSource, int gestureId, Runnable undoAction, Runnable redoAction) implements Edit {

    @Override
    public String name() {
        return nameSource.get();
    }

    @Override
    public void apply(UndoController controller, boolean redone) {
        (redone ? redoAction : undoAction).run();
    }

    /** Returns one edit that replaces this one and a later one of the same gesture. */
    SetupEdit mergedWith(SetupEdit later) {
        return new SetupEdit(later.nameSource, gestureId, undoAction, later.redoAction);
    }
}
