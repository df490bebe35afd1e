package faultline.gui.edit;

import java.util.List;
import javax.swing.undo.UndoManager;
import javax.swing.undo.UndoableEdit;

/**
 * The edits so far. One that came to nothing is not kept. A new edit drops what was undone, as everywhere; but not what
 * is undone only because the run was taken back to a moment before it: that can still be redone.
 */
final class EditHistory extends UndoManager {

    private static final int MAX_EDITS = 1000;

    private boolean quiet;

    EditHistory() {
        setLimit(MAX_EDITS);
    }

    @Override
    public synchronized boolean addEdit(UndoableEdit edit) {
        List<CommandEdit> later = editsAhead();
        boolean added = super.addEdit(edit);
        if (lastEdit() instanceof CommandEdit last && last.isNoOp()) {
            trimEdits(edits.size() - 1, edits.size() - 1);
        }
        quietly(() -> restoreAhead(later));
        return added;
    }

    private void restoreAhead(List<CommandEdit> later) {
        later.forEach(edit -> {
            edit.redo();
            super.addEdit(edit);
        });
        later.forEach(edit -> undo());
        later.forEach(edit -> edit.setAhead(true));
    }

    /** What can be redone only because the run stands at a moment before it. */
    List<CommandEdit> editsAhead() {
        UndoableEdit next = editToBeRedone();
        return next == null
                ? List.of()
                : edits.subList(edits.indexOf(next), edits.size()).stream()
                        .filter(CommandEdit.class::isInstance)
                        .map(CommandEdit.class::cast)
                        .filter(CommandEdit::isAhead)
                        .toList();
    }

    /** Whether an edit is one of its own here, rather than a part of another. */
    boolean contains(CommandEdit edit) {
        return edits.contains(edit);
    }

    /**
     * The run has come past the moment when an edit was done, or was taken back before the moment when it was undone.
     */
    void redoQuietly(CommandEdit edit) {
        if (editToBeRedone() == edit) {
            quietly(this::redo);
        }
    }

    /**
     * The run has come past the moment when an edit was undone, or, which is later then, was taken back before the
     * moment when it was done.
     */
    void undoQuietly(CommandEdit edit, boolean later) {
        if (editToBeUndone() == edit) {
            quietly(this::undo);
            edit.setAhead(later);
        }
    }

    /** The world has refused to do an edit again, or to undo it: it stands where it stood. */
    void revert(CommandEdit edit, boolean done) {
        if (done) {
            undoQuietly(edit, false);
        } else {
            redoQuietly(edit);
        }
    }

    private void quietly(Runnable move) {
        quiet = true;
        move.run();
        quiet = false;
    }

    /** Whether edits change sides here without anything being done to the run. */
    boolean isQuiet() {
        return quiet;
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
