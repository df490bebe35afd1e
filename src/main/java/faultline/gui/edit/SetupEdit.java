package faultline.gui.edit;

/**
 * A change of the scenario's setup. Undoing it runs the scenario again with the old setup.
 *
 * @param name the name that menus show
 * @param gestureId edits of one gesture are merged
 * @param undoAction restores the old setup
 * @param redoAction sets the new setup
 */
record SetupEdit(String name, int gestureId, Runnable undoAction, Runnable redoAction) implements Edit {

    /** Returns one edit in place of this one and a later one of the same gesture. */
    SetupEdit mergedWith(SetupEdit later) {
        return new SetupEdit(later.name, gestureId, undoAction, later.redoAction);
    }
}
