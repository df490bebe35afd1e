package faultline.gui.export;

import faultline.gui.document.ExitGuard;
import faultline.gui.text.Messages;
import faultline.io.AtomicFile;
import java.awt.Component;
import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import javax.swing.ProgressMonitor;
import javax.swing.SwingWorker;

/**
 * Writes one export off the event dispatch thread; what takes long shows how far it is and can be cancelled, which
 * leaves no file.
 */
final class ExportTask extends SwingWorker<Void, Void> {

    private static final int MAX_PROGRESS = 100;

    private final FileExport export;
    private final Path file;
    private final Consumer<Path> onWritten;
    private final Consumer<Throwable> onFailed;
    private final ProgressMonitor monitor;

    ExportTask(Component parent, FileExport export, Path file, Consumer<Path> written, Consumer<Throwable> failed) {
        assert EventQueue.isDispatchThread();
        this.export = export;
        this.file = file;
        this.onWritten = written;
        this.onFailed = failed;
        monitor = new ProgressMonitor(
                parent, Messages.get("export.writing", String.valueOf(file.getFileName())), "", 0, MAX_PROGRESS);
        addPropertyChangeListener(change -> {
            if (change.getPropertyName().equals("progress")) {
                updateMonitor((Integer) change.getNewValue());
            }
        });
    }

    /** Begins, and keeps the program from ending before it is done: a window may be closed meanwhile. */
    void start() {
        execute();
        ExitGuard.keepAliveUntilDone(this);
    }

    private void updateMonitor(int percent) {
        // The last step closes the monitor, and is left to the end.
        monitor.setProgress(Math.min(percent, MAX_PROGRESS - 1));
        if (monitor.isCanceled()) {
            cancel(false);
        }
    }

    @Override
    protected Void doInBackground() throws IOException {
        try (AtomicFile out = AtomicFile.create(file)) {
            export.write(out.stream(), this::reportProgress);
            out.commit();
        }
        return null;
    }

    private void reportProgress(double share) {
        if (isCancelled()) {
            throw new CancellationException();
        }
        setProgress((int) (MAX_PROGRESS * share));
    }

    @Override
    protected void done() {
        monitor.close();
        try {
            get();
            onWritten.accept(file);
        } catch (ExecutionException broken) {
            onFailed.accept(broken.getCause());
        } catch (CancellationException cancelled) {
            // As the user wanted.
        } catch (InterruptedException broken) {
            Thread.currentThread().interrupt();
        }
    }
}
