package faultline.gui.export;

import faultline.gui.document.BackgroundTasks;
import faultline.gui.document.FileNames;
import faultline.gui.document.TaskProgress;
import faultline.gui.text.Messages;
import faultline.io.AtomicFile;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Consumer;
import javax.swing.ProgressMonitor;
import javax.swing.Timer;

/** Writes an export in the background. A long one shows its progress and can be cancelled, which leaves no file. */
final class ExportTask {

    /** Fine, because the dialog opens with the first step, and a step of a long animation can take a minute. */
    private static final int MAX_PROGRESS = 1000;

    private static final int POLL_MILLIS = 50;

    private final FileExport export;
    private final Path file;
    private final Runnable onEnd;
    private final Consumer<Path> onWritten;
    private final Consumer<Throwable> onFailed;
    private final TaskProgress progress = new TaskProgress();
    private final ProgressMonitor monitor;
    private final Timer timer = new Timer(POLL_MILLIS, event -> updateMonitor());
    private int shownProgress;

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
        this.export = export;
        this.file = file;
        this.onEnd = onEnd;
        this.onWritten = onWritten;
        this.onFailed = onFailed;
        monitor = new ProgressMonitor(
                parent, Messages.get("export.writing", FileNames.lastOf(file)), "", 0, MAX_PROGRESS);
        if (GraphicsEnvironment.isHeadless()) {
            // Without a display, its dialog, which a slow export opens, would end the task.
            monitor.setMillisToDecideToPopup(Integer.MAX_VALUE);
        }
    }

    /** Starts the task, and keeps the program from exiting before it has ended. */
    void start() {
        timer.start();
        BackgroundTasks.performBeforeExit(this::write, this::written, this::failed);
    }

    /** Returns whether the task has ended. */
    boolean isDone() {
        return !timer.isRunning();
    }

    private void updateMonitor() {
        int reached = (int) (MAX_PROGRESS * progress.fraction().orElse(0));
        if (reached > shownProgress) {
            shownProgress = reached;
            // The last step would close the monitor before the file is complete.
            monitor.setProgress(Math.min(reached, MAX_PROGRESS - 1));
        }
        if (monitor.isCanceled()) {
            progress.cancel();
        }
    }

    private void write() throws IOException {
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
        monitor.close();
        onEnd.run();
    }
}
