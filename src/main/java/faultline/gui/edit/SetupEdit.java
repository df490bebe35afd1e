package faultline.gui.edit;

import faultline.gui.change.Rename;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/**
 * A change of the scenario's setup, named in the current language. Undoing it runs the scenario again with the old
 * setup. Edits of one gesture are merged.
 *
 * @param nameSource returns the name
 * @param gestureId the gesture that the edit belongs to
 * @param change the change
 * @param renames the changes of ids among what the edit changes, in order
 */
record SetupEdit(Supplier<String> nameSource, int gestureId, SetupChange change, List<Rename> renames) implements Edit {

    SetupEdit {
        renames = List.copyOf(renames);
    }

    /** Creates an edit that changes no id. */
    SetupEdit(Supplier<String> nameSource, int gestureId, SetupChange change) {
        this(nameSource, gestureId, change, List.of());
    }

    @Override
    public String name() {
        return nameSource.get();
    }

    @Override
    public void apply(UndoController controller, boolean redone) {
        if (redone) {
            change.redo();
        } else {
            change.undo();
        }
    }

    /** Returns one edit that replaces this one and a later one of the same gesture. */
    SetupEdit mergedWith(SetupEdit later) {
        List<Rename> all = new ArrayList<>(renames);
        all.addAll(later.renames);
        return new SetupEdit(later.nameSource, gestureId, change.mergedWith(later.change), all);
    }
}
