package faultline.gui.document;

import faultline.scenario.Scenario;
import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.logging.Level;
import java.util.logging.Logger;
import javax.swing.Timer;

/** Keeps unsaved edits where a crash cannot reach them, twice a minute; what is saved or given up is kept no longer. */
public final class Autosave implements AutoCloseable {

    private static final Logger LOG = Logger.getLogger(Autosave.class.getName());
    private static final int PERIOD_MILLIS = 30_000;

    private final Workspace workspace;
    private final RecoveryStore recovery;
    private final Timer timer = new Timer(PERIOD_MILLIS, event -> saveUnsavedEdits());
    private volatile Optional<Scenario> lastWritten = Optional.empty();
    private volatile boolean closed;
    private boolean lastWriteSucceeded;

    /**
     * Begins to keep edits.
     *
     * @param bench whose
     * @param recovery where
     */
    public Autosave(Workspace bench, RecoveryStore recovery) {
        assert EventQueue.isDispatchThread();
        this.workspace = bench;
        this.recovery = recovery;
        timer.start();
    }

    /** Keeps what is unsaved now, or forgets what was, unless that is done already. */
    void saveUnsavedEdits() {
        Optional<Scenario> unsaved = workspace.scenario().filter(scenario -> workspace.isChanged());
        if (!lastWriteSucceeded || !unsaved.equals(lastWritten)) {
            lastWritten = unsaved;
            lastWriteSucceeded = true;
            Optional<Path> origin = workspace.file();
            BackgroundTasks.run(
                    () -> {
                        write(origin, unsaved);
                        return unsaved;
                    },
                    done -> {},
                    why -> {
                        // Next time, once more.
                        lastWriteSucceeded = false;
                        LOG.log(Level.WARNING, "unsaved edits cannot be kept", why);
                    });
        }
    }

    /** One at a time, each for as long as nothing newer is to be kept; and none after the end. */
    synchronized void write(Optional<Path> origin, Optional<Scenario> unsaved) throws IOException {
        if (closed || !unsaved.equals(lastWritten)) {
            return;
        }
        if (unsaved.isPresent()) {
            recovery.save(origin, unsaved.get());
        } else {
            recovery.delete();
        }
    }

    /** The window closes in good order: nothing is to be recovered. */
    @Override
    public void close() {
        timer.stop();
        closed = true;
        BackgroundTasks.runBeforeExit(
                () -> {
                    discardRecoveryFile();
                    return recovery;
                },
                done -> {},
                why -> LOG.log(Level.WARNING, "kept edits cannot be taken away", why));
    }

    private synchronized void discardRecoveryFile() throws IOException {
        recovery.delete();
    }
}
