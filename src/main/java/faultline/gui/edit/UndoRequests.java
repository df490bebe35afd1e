package faultline.gui.edit;

import faultline.gui.document.RunController;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/**
 * Undoes and redoes edits on request. A request waits until the run has answered the edits and requests before it,
 * since an edit that is refused is not undone, and one whose undo is refused stays done, and until a run that is being
 * restarted or moved has its events on the timeline and its other edits at the start. A new edit drops the requests
 * that wait, because it was made without their effects. Event dispatch thread only.
 */
final class UndoRequests {

    private final EditHistory history;
    private final EditAction action;
    private final Deque<Kind> waiting = new ArrayDeque<>();
    /** Null for a run that is neither restarted nor moved. */
    private RunController run;

    /** The numbers of edits, and of undone and redone edits, that the run has not answered. */
    private int unanswered;

    private int unansweredRequests;
    /** The edits that are made when the run has answered all edits that are undone and redone. */
    private final List<Runnable> waitingEdits = new ArrayList<>();
    /** Whether the requests will be processed when the run has been restarted or moved. */
    private boolean deferred;

    private enum Kind {
        UNDO,
        REDO
    }

    /** Redoes or undoes an edit. */
    @FunctionalInterface
    interface EditAction {
        void apply(Edit edit, boolean redone);
    }

    UndoRequests(EditHistory history, EditAction action) {
        this.history = history;
        this.action = action;
    }

    /** Sets the run that may be restarted or moved to another tick. */
    void setRun(RunController newRun) {
        run = newRun;
    }

    /** Records that an edit has been made. */
    void editMade() {
        waiting.clear();
    }

    /** Records that the commands of an edit are being sent; {@link #answered} must follow. */
    void editSent() {
        editMade();
        unanswered++;
    }

    /** Records that the run has answered the commands of an edit, which is in the history unless it was refused. */
    void answered() {
        unanswered--;
        process();
    }

    /**
     * Records that the commands of an edit that is undone or redone are being sent; {@link #requestAnswered} follows.
     */
    void requestSent() {
        unansweredRequests++;
    }

    /** Records that the run has answered the commands of an edit that is undone or redone. */
    void requestAnswered() {
        unansweredRequests--;
        if (unansweredRequests == 0 && !waitingEdits.isEmpty()) {
            List<Kind> later = List.copyOf(waiting);
            List<Runnable> edits = List.copyOf(waitingEdits);
            waitingEdits.clear();
            edits.forEach(Runnable::run);
            waiting.addAll(later);
        }
        process();
    }

    /** Makes an edit as soon as the run has answered the edits that are undone or redone. */
    void editWhenAnswered(Runnable edit) {
        editMade();
        if (unansweredRequests == 0) {
            edit.run();
        } else {
            waitingEdits.add(edit);
        }
    }

    void undo() {
        request(Kind.UNDO);
    }

    void redo() {
        request(Kind.REDO);
    }

    private void request(Kind kind) {
        waiting.add(kind);
        process();
    }

    /** Returns whether an edit is made later, or the run has not answered all edits, so that one may be undone. */
    boolean awaitsEdit() {
        return unanswered > 0 || !waitingEdits.isEmpty();
    }

    /** Returns whether requests wait, so that an edit may be redone later. */
    boolean isWaiting() {
        return !waiting.isEmpty();
    }

    /** Executes the requests that need not wait any longer. */
    private void process() {
        while (unanswered + unansweredRequests == 0 && !waiting.isEmpty()) {
            boolean redone = waiting.peek() == Kind.REDO;
            Optional<Edit> next = redone ? history.nextRedo() : history.nextUndo();
            if (next.filter(this::mustWait).isPresent()) {
                processLater();
                return;
            }
            waiting.remove();
            next.ifPresent(edit -> action.apply(edit, redone));
        }
    }

    private boolean mustWait(Edit edit) {
        return run != null && edit instanceof CommandEdit && run.isRepositioning();
    }

    private void processLater() {
        if (!deferred) {
            deferred = true;
            run.runAfterRepositioning(() -> {
                deferred = false;
                process();
            });
        }
    }

    /** Forgets all requests and edits, because another scenario has been opened. */
    void clear() {
        waiting.clear();
        waitingEdits.clear();
        unanswered = 0;
        unansweredRequests = 0;
        deferred = false;
    }
}
