package faultline.gui.dialog;

import faultline.gui.document.TaskProgress;
import java.awt.Dialog;
import java.awt.EventQueue;
import java.awt.Window;
import java.util.Optional;
import java.util.stream.Stream;

/** Shows what is under way once it has taken long enough for a user to wonder, and lets it be given up. */
public final class ProgressDialogs {

    /** At sixty looks in a second, half a second. */
    private static final int POLLS_BEFORE_DIALOG = 30;

    private final Window owner;
    private final Runnable cancelHandler;
    private Optional<TaskProgress> currentTask = Optional.empty();
    private Optional<ProgressDialog> dialog = Optional.empty();
    private int polls;

    public ProgressDialogs(Window owner, Runnable cancel) {
        this.owner = owner;
        this.cancelHandler = cancel;
    }

    /** Shows how it stands; asked some sixty times in a second. */
    public void update(Optional<TaskProgress> now) {
        if (!now.equals(currentTask)) {
            closeDialog();
            currentTask = now;
        }
        now.ifPresent(this::update);
    }

    private void update(TaskProgress way) {
        polls += isOtherDialogOpen() ? 0 : 1;
        dialog.ifPresent(shown -> shown.setProgress(way.fraction()));
        if (polls == POLLS_BEFORE_DIALOG) {
            ProgressDialog made = new ProgressDialog(owner, way, cancelHandler);
            dialog = Optional.of(made);
            // Not at once: whoever looks here must be able to look again while the dialog is open.
            EventQueue.invokeLater(
                    () -> dialog.filter(shown -> shown == made).ifPresent(shown -> shown.setVisible(true)));
        }
    }

    /** Whether another question is open: one at a time. */
    private boolean isOtherDialogOpen() {
        return dialog.isEmpty()
                && Stream.of(owner.getOwnedWindows())
                        .anyMatch(window -> window instanceof Dialog && window.isShowing());
    }

    private void closeDialog() {
        dialog.ifPresent(Window::dispose);
        dialog = Optional.empty();
        polls = 0;
    }
}
