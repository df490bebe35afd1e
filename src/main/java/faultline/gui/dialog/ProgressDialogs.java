package faultline.gui.dialog;

import faultline.gui.document.FileNames;
import faultline.gui.document.ModalDialogs;
import faultline.gui.document.WorkspaceTask;
import faultline.gui.text.Messages;
import java.awt.Dialog;
import java.awt.EventQueue;
import java.awt.Window;

/** Shows a progress dialog for a task that takes longer than half a second, and lets the user cancel it. */
public final class ProgressDialogs {

    /** Half a second at sixty polls per second. */
    private static final int POLLS_BEFORE_DIALOG = 30;

    private final Window owner;
    private final Runnable cancelHandler;
    /** Null if no task runs. */
    private WorkspaceTask currentTask;
    /** Null if none is open. */
    private ProgressDialog dialog;

    private int polls;

    public ProgressDialogs(Window owner, Runnable cancel) {
        this.owner = owner;
        this.cancelHandler = cancel;
    }

    /** Updates the dialog of the current task; called about sixty times per second while a task runs. */
    public void update(WorkspaceTask task) {
        if (!task.equals(currentTask)) {
            closeDialog();
            currentTask = task;
        }
        polls += dialog == null && ModalDialogs.isAnyOpen() ? 0 : 1;
        if (dialog != null) {
            dialog.setProgress(task.progress());
        }
        if (polls == POLLS_BEFORE_DIALOG) {
            ProgressDialog created = createDialog(task);
            dialog = created;
            // Asynchronously: the caller must be able to poll again while the modal dialog is open.
            EventQueue.invokeLater(() -> {
                if (dialog == created) {
                    created.setVisible(true);
                }
            });
        }
    }

    private ProgressDialog createDialog(WorkspaceTask task) {
        ProgressDialog created = new ProgressDialog(
                owner,
                () -> Messages.get("wait.title"),
                Dialog.ModalityType.APPLICATION_MODAL,
                () -> Messages.get("wait." + task.kind(), FileNames.lastOf(task.name())),
                cancelHandler);
        created.setProgress(task.progress());
        return created;
    }

    /** Closes the dialog, because no task runs. */
    public void clear() {
        if (currentTask != null) {
            closeDialog();
            currentTask = null;
        }
    }

    private void closeDialog() {
        if (dialog != null) {
            dialog.dispose();
            dialog = null;
        }
        polls = 0;
    }
}
