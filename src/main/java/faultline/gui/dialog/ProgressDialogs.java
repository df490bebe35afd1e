package faultline.gui.dialog;

import faultline.gui.document.WorkspaceTask;
import java.awt.Dialog;
import java.awt.EventQueue;
import java.awt.Window;
import java.util.Optional;
import java.util.stream.Stream;

/** Shows a progress dialog for a task that takes longer than half a second, and lets the user cancel it. */
public final class ProgressDialogs {

    /** Half a second at sixty polls per second. */
    private static final int POLLS_BEFORE_DIALOG = 30;

    private final Window owner;
    private final Runnable cancelHandler;
    private Optional<WorkspaceTask> currentTask = Optional.empty();
    private Optional<ProgressDialog> dialog = Optional.empty();
    private int polls;

    public ProgressDialogs(Window owner, Runnable cancel) {
        this.owner = owner;
        this.cancelHandler = cancel;
    }

    /** Updates the dialog; called about sixty times per second. */
    public void update(Optional<WorkspaceTask> now) {
        if (!now.equals(currentTask)) {
            closeDialog();
            currentTask = now;
        }
        now.ifPresent(this::update);
    }

    private void update(WorkspaceTask task) {
        polls += isOtherDialogOpen() ? 0 : 1;
        dialog.ifPresent(shown -> shown.setProgress(task.progress().fraction()));
        if (polls == POLLS_BEFORE_DIALOG) {
            ProgressDialog made = new ProgressDialog(owner, task, cancelHandler);
            dialog = Optional.of(made);
            // Asynchronously: the caller must be able to poll again while the modal dialog is open.
            EventQueue.invokeLater(
                    () -> dialog.filter(shown -> shown == made).ifPresent(shown -> shown.setVisible(true)));
        }
    }

    /** Returns whether another modal dialog is open. */
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
