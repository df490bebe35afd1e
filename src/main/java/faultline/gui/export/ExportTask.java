package faultline.gui.export;

import faultline.gui.document.Guard;
import faultline.gui.text.Texts;
import faultline.scenario.AtomicFile;
import java.awt.Component;
import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import javax.swing.ProgressMonitor;
import javax.swing.SwingWorker;

/** Writes one export off the event dispatch thread; what takes long shows how far it is and can be cancelled, which leaves no file. */
final class ExportTask extends SwingWorker<Void, Void> {

    private static final int WHOLE = 100;

    private final Export export;
    private final Path file;
    private final Consumer<Path> written;
    private final Consumer<Throwable> failed;
    private final ProgressMonitor monitor;

    ExportTask(Component parent, Export export, Path file, Consumer<Path> written, Consumer<Throwable> failed) {
        assert EventQueue.isDispatchThread();
        this.export = export;
        this.file = file;
        this.written = written;
        this.failed = failed;
        monitor = new ProgressMonitor(parent, Texts.text("export.writing", String.valueOf(file.getFileName())), "", 0, WHOLE);
        addPropertyChangeListener(change -> {
            if (change.getPropertyName().equals("progress")) {
                show((Integer) change.getNewValue());
            }
        });
    }

    /** Begins, and keeps the program from ending before it is done: a window may be closed meanwhile. */
    void begin() {
        execute();
        Guard.until(this);
    }

    private void show(int percent) {
        // The last step closes the monitor, and is left to the end.
        monitor.setProgress(Math.min(percent, WHOLE - 1));
        if (monitor.isCanceled()) {
            cancel(false);
        }
    }

    @Override
    protected Void doInBackground() throws IOException {
        try (AtomicFile out = AtomicFile.create(file)) {
            export.write(out.stream(), this::reached);
            out.commit();
        }
        return null;
    }

    private void reached(double share) {
        if (isCancelled()) {
            throw new CancellationException();
        }
        setProgress((int) (WHOLE * share));
    }

    @Override
    protected void done() {
        monitor.close();
        try {
            get();
            written.accept(file);
        } catch (ExecutionException broken) {
            failed.accept(broken.getCause());
        } catch (CancellationException cancelled) {
            // As the user wanted.
        } catch (InterruptedException broken) {
            Thread.currentThread().interrupt();
        }
    }
}
