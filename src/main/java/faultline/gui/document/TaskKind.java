package faultline.gui.document;

/** The kinds of background tasks. */
public enum TaskKind {
    /** Opening a scenario. */
    OPEN,
    /** Saving the scenario. */
    SAVE,
    /** Saving the journal. */
    SAVE_JOURNAL,
    /** Restarting the run. */
    RESTART,
    /** Moving the run to another tick. */
    GO_TO,
    /** Replaying a reference run. */
    GHOST
}
