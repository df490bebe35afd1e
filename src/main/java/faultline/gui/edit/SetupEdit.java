package faultline.gui.edit;

import faultline.gui.document.SensorRename;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/**
 * A change of the scenario's setup, named in the current language. Undoing it runs the scenario again with the old
 * setup. Edits of one gesture are merged.
 *
 * @param nameSource returns the name
 * @param gestureId the gesture that the edit belongs to
 * @param undoAction what undoes the change
 * @param redoAction what makes the change again
 * @param renames the changes of ids among what the edit changes, in order
 */
record SetupEdit(
        Supplier<String> nameSource,
        int gestureId,
        Runnable undoAction,
        Runnable redoAction,
        List<SensorRename> renames)
        implements Edit {

    SetupEdit {
        renames = List.copyOf(renames);
    }

    /** Creates an edit that changes no id. */
    SetupEdit(Supplier<String> nameSource, int gestureId, Runnable undoAction, Runnable redoAction) {
        this(nameSource, gestureId, undoAction, redoAction, List.of());
    }

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
        List<SensorRename> all = new ArrayList<>(renames);
        all.addAll(later.renames);
        return new SetupEdit(later.nameSource, gestureId, undoAction, later.redoAction, all);
    }
}
