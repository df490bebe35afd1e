package faultline.gui.edit;

import javax.swing.undo.UndoManager;
import javax.swing.undo.UndoableEdit;

/** The edits so far. One that came to nothing is not kept. */
final class EditHistory extends UndoManager {

    private static final int MOST_EDITS = 1000;

    EditHistory() {
        setLimit(MOST_EDITS);
    }

    @Override
    public synchronized boolean addEdit(UndoableEdit edit) {
        boolean added = super.addEdit(edit);
        if (lastEdit() instanceof CommandEdit last && last.isNothing()) {
            trimEdits(edits.size() - 1, edits.size() - 1);
        }
        return added;
    }

    /** What undo would take back; asked only where there is something. */
    String undoName() {
        return editToBeUndone().getPresentationName();
    }

    /** What redo would do; asked only where there is something. */
    String redoName() {
        return editToBeRedone().getPresentationName();
    }
}
