package faultline.gui.edit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The edits, and a cursor between those that are done and those that are undone. A new edit drops the undone ones, but
 * keeps those that are undone only because the run stands at an earlier tick: they can still be redone.
 */
final class EditHistory {

    private static final int MAX_EDITS = 1000;

    private final List<Edit> edits = new ArrayList<>();
    /** The number of edits that are done; they come first. */
    private int cursor;

    /**
     * Adds an edit that is done. One of the same gesture as the last edit is merged into it; one without effect is
     * dropped.
     */
    void add(Edit edit) {
        List<CommandEdit> ahead = editsAhead();
        edits.subList(cursor, edits.size()).clear();
        if (!isMerged(edit)) {
            edits.add(edit);
        }
        if (last() instanceof CommandEdit last && last.isNoOp()) {
            edits.remove(last);
        }
        edits.subList(0, Math.max(0, edits.size() - MAX_EDITS)).clear();
        cursor = edits.size();
        edits.addAll(ahead);
    }

    private boolean isMerged(Edit edit) {
        if (last() instanceof SetupEdit last
                && edit instanceof SetupEdit newer
                && last.gestureId() == newer.gestureId()) {
            edits.set(edits.size() - 1, last.mergedWith(newer));
            return true;
        }
        return last() instanceof CommandEdit last && edit instanceof CommandEdit newer && last.merge(newer);
    }

    private Edit last() {
        return edits.isEmpty() ? null : edits.get(edits.size() - 1);
    }

    /** Returns the edits that can be redone only because the run stands at an earlier tick. */
    List<CommandEdit> editsAhead() {
        return edits.subList(cursor, edits.size()).stream()
                .filter(edit -> edit instanceof CommandEdit command && command.isAhead())
                .map(CommandEdit.class::cast)
                .toList();
    }

    /** Returns whether an edit is an entry of its own. */
    boolean contains(Edit edit) {
        return edits.contains(edit);
    }

    /** Returns the edit that is undone next. */
    Optional<Edit> nextUndo() {
        return cursor > 0 ? Optional.of(edits.get(cursor - 1)) : Optional.empty();
    }

    /** Returns the edit that is redone next. */
    Optional<Edit> nextRedo() {
        return cursor < edits.size() ? Optional.of(edits.get(cursor)) : Optional.empty();
    }

    /** Moves the cursor before an edit if it is undone next; {@code ahead} says that the run stands before the edit. */
    void markUndone(Edit edit, boolean ahead) {
        if (nextUndo().filter(edit::equals).isPresent()) {
            cursor--;
            setAhead(edit, ahead);
        }
    }

    /** Moves the cursor past an edit if it is redone next. */
    void markDone(Edit edit) {
        if (nextRedo().filter(edit::equals).isPresent()) {
            cursor++;
            setAhead(edit, false);
        }
    }

    private static void setAhead(Edit edit, boolean ahead) {
        if (edit instanceof CommandEdit command) {
            command.setAhead(ahead);
        }
    }

    void clear() {
        edits.clear();
        cursor = 0;
    }
}
