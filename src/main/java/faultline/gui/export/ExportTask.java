package faultline.gui.export;

import faultline.gui.dialog.ProgressDialog;
import faultline.gui.document.BackgroundTasks;
import faultline.gui.document.FileNames;
import faultline.gui.document.TaskProgress;
import faultline.gui.text.Messages;
import faultline.io.AtomicFile;
import faultline.io.LinkResolver;
import java.awt.Component;
import java.awt.Dialog;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Consumer;
import javax.swing.JOptionPane;
import javax.swing.Timer;

/** Writes an export in the background. A long one shows its progress and can be cancelled, which leaves no file. */
final class ExportTask {

    private static final int POLL_MILLIS = 50;

    /** The time after which the dialog opens. */
    private static final long NANOS_BEFORE_DIALOG = 700_000_000;

    /** The time that an export takes at least, by its progress so far, if the dialog opens. */
    private static final double NANOS_WITH_DIALOG = 2e9;

    private final FileExport export;
    private final Path file;
    private final Runnable onEnd;
    private final Consumer<Path> onWritten;
    private final Consumer<Throwable> onFailed;
    private final TaskProgress progress = new TaskProgress();
    private final Component parent;
    private final Timer timer = new Timer(POLL_MILLIS, event -> updateDialog());
    /** On the clock of {@link System#nanoTime}. */
    private long startNanos;
    /** Null before it opens. */
    private ProgressDialog dialog;

    /**
     * Creates a task; {@code onEnd} runs when it has ended. If it was cancelled, {@code onFailed} receives a
     * {@link java.util.concurrent.CancellationException}.
     */
    ExportTask(
            Component parent,
            FileExport export,
            Path file,
            Runnable onEnd,
            Consumer<Path> onWritten,
            Consumer<Throwable> onFailed) {
        assert EventQueue.isDispatchThread();
        this.parent = parent;
        this.export = export;
        this.file = file;
        this.onEnd = onEnd;
        this.onWritten = onWritten;
        this.onFailed = onFailed;
    }

    /** Starts the task, and keeps the program from exiting before it has ended. */
    void start() {
        startNanos = System.nanoTime();
        timer.start();
        BackgroundTasks.performBeforeExit(this::write, this::written, this::failed);
    }

    /** Returns whether the task has ended. */
    boolean isDone() {
        return !timer.isRunning();
    }

    /** Returns the name of the file. */
    String name() {
        return FileNames.lastOf(file);
    }

    /** Cancels the task, which ends soon afterwards. */
    void cancel() {
        progress.cancel();
    }

    private void updateDialog() {
        if (dialog == null && needsDialog()) {
            openDialog();
        }
        if (dialog != null) {
            dialog.setProgress(progress);
        }
    }

    /** Returns whether the task is slow. Without a display, no dialog can open. */
    private boolean needsDialog() {
        long elapsed = System.nanoTime() - startNanos;
        return progress.isActive()
                && elapsed >= NANOS_BEFORE_DIALOG
                && elapsed >= NANOS_WITH_DIALOG * progress.fraction().orElse(0)
                && !GraphicsEnvironment.isHeadless();
    }

    private void openDialog() {
        dialog = new ProgressDialog(
                JOptionPane.getFrameForComponent(parent),
                () -> Messages.get("export.title"),
                Dialog.ModalityType.MODELESS,
                () -> Messages.get("export.writing", name()),
                this::cancel);
        dialog.setVisible(true);
    }

    private void write() throws IOException {
        LinkResolver.refuseDevice(file);
        try (AtomicFile out = AtomicFile.create(file)) {
            export.write(out.stream(), progress);
            progress.throwIfCancelled();
            out.commit();
        }
    }

    private void written() {
        end();
        onWritten.accept(file);
    }

    private void failed(Throwable failure) {
        end();
        onFailed.accept(failure);
    }

    private void end() {
        timer.stop();
        if (dialog != null) {
            dialog.dispose();
        }
        onEnd.run();
    }
}
