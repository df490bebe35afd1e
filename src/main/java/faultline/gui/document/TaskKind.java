package faultline.gui.document;

/**
 * The kinds of background tasks; {@code GO_TO} moves the run to another tick, {@code RESIMULATE} simulates it again
 * with a changed setup, and {@code GHOST} replays a reference run.
 */
public enum TaskKind {
    OPEN,
    SAVE,
    SAVE_JOURNAL,
    RESTART,
    GO_TO,
    RESIMULATE,
    GHOST
}
