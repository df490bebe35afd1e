package faultline.gui.document;

import java.nio.file.Path;

/** Told of what happens on the bench. */
public interface WorkspaceListener {

    /** A new session has begun: of another file, or of the same scenario anew. */
    void sessionStarted();

    /** The name of the file, or whether there are unsaved changes, is another now. */
    void titleChanged();

    /**
     * Something asked for could not be done; all is as it was before.
     *
     * @param what was being done
     * @param file with which file
     * @param why the exception
     */
    void taskFailed(TaskKind what, Path file, Throwable why);

    /** Another scenario is on the bench; told before its session begins. */
    default void scenarioOpened() {}

    /** The same scenario begins anew as it is edited by now; told before its session begins. */
    default void scenarioRestarted() {}

    /**
     * The run stands at another moment of its own; what was done later is still ahead. Told before its session begins.
     *
     * @param tick that has passed
     */
    default void runRepositioned(long tick) {}

    /**
     * A scenario is in its file as it was edited when that was asked for.
     *
     * @param file that one; by now another may be open
     * @param whole whether that is all that was done to the run; switches and faults are no part of a scenario
     */
    default void scenarioSaved(Path file, boolean whole) {}

    /**
     * The journal is in a file.
     *
     * @param file that one
     */
    default void journalSaved(Path file) {}
}
