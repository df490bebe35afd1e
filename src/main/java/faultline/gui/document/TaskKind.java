package faultline.gui.document;

/** What takes a while on the bench. */
public enum TaskKind {
    /** Reading a scenario. */
    OPEN,
    /** Writing the scenario. */
    SAVE,
    /** Writing the journal. */
    SAVE_JOURNAL,
    /** Beginning anew. */
    RESTART,
    /** Going to another moment of the run. */
    GO_TO,
    /** Running an earlier run again, to be shown beside this one. */
    GHOST
}
