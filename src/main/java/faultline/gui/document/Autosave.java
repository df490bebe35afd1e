package faultline.gui.document;

import faultline.scenario.Scenario;
import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.logging.Level;
import java.util.logging.Logger;
import javax.swing.Timer;

/** Writes unsaved edits to a recovery file twice a minute, and deletes the file as soon as there are none. */
public final class Autosave implements AutoCloseable {

    private static final Logger LOG = Logger.getLogger(Autosave.class.getName());
    /** The time between two writes. */
    static final int PERIOD_MILLIS = 30_000;

    private final Workspace workspace;
    private final RecoveryStore recovery;
    private final Consumer<Throwable> onFailure;
    private final Timer timer = new Timer(PERIOD_MILLIS, event -> saveUnsavedEdits());
    /** Null if there was nothing to save. */
    private volatile Scenario lastWritten;

    private volatile boolean closed;
    private boolean lastWriteSucceeded;
    /** Whether there are edits that could not be saved, as far as is known. */
    private boolean failing;

    /**
     * Starts to save the edits of a workspace to a recovery store. {@code onFailure} is called on the event dispatch
     * thread when edits cannot be saved; not again before that has succeeded or there are no edits.
     */
    public Autosave(Workspace workspace, RecoveryStore recovery, Consumer<Throwable> onFailure) {
        assert EventQueue.isDispatchThread();
        this.workspace = workspace;
        this.recovery = recovery;
        this.onFailure = onFailure;
        timer.start();
        workspace.addListener(new WorkspaceListener() {
            @Override
            public void titleChanged() {
                // Older edits must not be offered in place of those that have been saved.
                if (hasEdits() && !workspace.isChanged() && !closed) {
                    saveUnsavedEdits();
                }
            }

            @Override
            public void workspaceClosing() {
                close();
            }
        });
    }

    /**
     * Writes the unsaved edits, or deletes the recovery file if there are none. Does nothing if the file is up to date.
     * Writes those that wait for the run as soon as they are made.
     */
    void saveUnsavedEdits() {
        if (workspace.awaitsCommands()) {
            workspace.edited().ifPresent(edited -> edited.thenRun(this::saveKnownEdits));
        }
        saveKnownEdits();
    }

    private void saveKnownEdits() {
        Scenario unsaved = unsavedEdits();
        if (!lastWriteSucceeded || !Objects.equals(unsaved, lastWritten)) {
            lastWritten = unsaved;
            lastWriteSucceeded = true;
            failing &= unsaved != null;
            Path origin = workspace.file().orElse(null);
            Scenario base = workspace.replaceableScenario().orElse(null);
            BackgroundTasks.perform(() -> write(origin, base, unsaved), () -> failing = false, this::writeFailed);
        }
    }

    /** Returns the scenario with its unsaved edits, null if there are none; without those that wait for the run. */
    private Scenario unsavedEdits() {
        return workspace
                .scenario()
                .filter(now -> !workspace.savedScenario().equals(Optional.of(now)))
                .orElse(null);
    }

    /** Notes that the recovery store holds these edits, which were recovered after a crash. */
    void editsAdopted(Scenario recovered) {
        lastWritten = recovered;
    }

    /** Returns whether the recovery store holds edits, or will when a write has ended. */
    boolean hasEdits() {
        return lastWritten != null;
    }

    /** Returns whether there are edits that could not be saved when that was last tried. */
    public boolean isFailing() {
        return failing;
    }

    private void writeFailed(Throwable failure) {
        // The next period tries again.
        lastWriteSucceeded = false;
        log(Level.FINE, "the unsaved edits cannot be written to the recovery file", failure);
        if (!failing && hasEdits()) {
            failing = true;
            onFailure.accept(failure);
        }
    }

    /** Writes edits, null for none, unless newer ones are waiting or the window has been closed. */
    synchronized void write(Path origin, Scenario base, Scenario unsaved) throws IOException {
        if (!closed && Objects.equals(unsaved, lastWritten)) {
            replaceRecoveryFile(origin, base, unsaved);
        }
    }

    private synchronized void replaceRecoveryFile(Path origin, Scenario base, Scenario unsaved) throws IOException {
        if (unsaved == null) {
            recovery.delete();
        } else {
            recovery.save(origin, base, unsaved);
        }
    }

    /**
     * Deletes the recovery file: the window closes normally and nothing needs to be recovered. Unsaved edits of a run
     * that has died are kept: perhaps they could not be saved.
     */
    @Override
    public void close() {
        if (closed) {
            return;
        }
        timer.stop();
        closed = true;
        Path origin = workspace.file().orElse(null);
        Scenario base = workspace.replaceableScenario().orElse(null);
        Scenario kept = workspace.hasRunDied() ? unsavedEdits() : null;
        BackgroundTasks.performBeforeExit(
                () -> replaceRecoveryFile(origin, base, kept),
                () -> {},
                failure -> log(Level.WARNING, "the recovery file cannot be written or deleted", failure));
    }

    /**
     * Logs a failure; one of a file at its own level and without a stack trace, because it is no defect of the program.
     */
    private static void log(Level ofFile, String what, Throwable failure) {
        if (failure instanceof IOException) {
            LOG.log(ofFile, () -> what + ": " + failure);
        } else {
            LOG.log(Level.WARNING, what, failure);
        }
    }
}
