package faultline.gui.document;

import faultline.engine.SimulationSetup;
import java.nio.file.Path;
import java.util.function.BooleanSupplier;

/** Receives events of a workspace, on the event dispatch thread. */
public interface WorkspaceListener {

    /** Another scenario has been opened. Followed by {@link #sessionStarted}. */
    default void scenarioOpened() {}

    /**
     * The edited scenario has been restarted, given the setup of the run before. Followed by {@link #sessionStarted}.
     */
    default void scenarioRestarted(SimulationSetup before) {}

    /**
     * All commands that the run of a setup has executed have become part of the edited scenario, because it has been
     * changed so that the run must restart.
     */
    default void editsIncluded(SimulationSetup before) {}

    /**
     * The run of a setup has been moved to the end of another tick; later edits are still ahead, unless all events of
     * the run, such as faults, have become commands of the timeline. Followed by {@link #sessionStarted}.
     */
    default void runRepositioned(long tick, SimulationSetup setup, boolean eventsOnTimeline) {}

    /** All events of the run of a setup have become commands of the timeline, while the run stays as it is. */
    default void eventsPutOnTimeline(SimulationSetup setup) {}

    /** The user moves the run to one of its ticks; {@link #runRepositioned} follows when it is there. */
    default void seekStarted(long tick) {}

    /**
     * The run has been moved to another tick, and its controller, which is not part of the program, has decided
     * differently than before: the run differs from a time on, seconds. Follows {@link #sessionStarted}.
     */
    default void decidedDifferently(double time) {}

    /**
     * The simulation of a changed setup has been cancelled or has failed: the change takes effect when the run is moved
     * or restarted.
     */
    default void setupChangeDeferred() {}

    /** The user pauses the run, which pauses when its controller has answered. */
    default void pauseRequested() {}

    /** The user wants to resume a run that has failed. */
    default void failedRunResumed() {}

    /** A new session has started. */
    default void sessionStarted() {}

    /** No task is active now: the last one has ended or has been cancelled. */
    default void taskFinished() {}

    /** The name of the file, or whether there are unsaved changes, may have changed. */
    default void titleChanged() {}

    /** A task that worked on a file has failed and has changed nothing. */
    default void taskFailed(TaskKind task, Path file, Throwable failure) {}

    /** A reference run is being loaded, has been loaded, or has been removed. */
    default void comparisonChanged() {}

    /** A save to a file takes long; it ends when {@code writing} returns false. */
    default void saveSlow(Path file, BooleanSupplier writing) {}

    /** The scenario has been saved to a file; another one may be open by now. */
    default void scenarioSaved(Path file) {}

    /** The journal has been saved to a file. */
    default void journalSaved(Path file) {}

    /** The workspace is about to close; the document is still open. */
    default void workspaceClosing() {}
}
