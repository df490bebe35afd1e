package faultline.gui.edit;

/** A change of the scenario's setup that has been made, and can be undone and made again. */
public interface SetupChange {
    /** Undoes the change. */
    void undo();

    /** Makes the change again. */
    void redo();

    /**
     * Returns whether the change is known to have no effect, such as one that a later one of its gesture has reversed.
     */
    default boolean isNoOp() {
        return false;
    }

    /** Returns the change that this one and a later one of the same gesture make together. */
    default SetupChange mergedWith(SetupChange later) {
        return of(this::undo, later::redo);
    }

    /**
     * Returns a change, given actions that set what it changes to the value before and after it, whatever the value is
     * now.
     */
    static SetupChange of(Runnable undo, Runnable redo) {
        return new SetupChange() {
            @Override
            public void undo() {
                undo.run();
            }

            @Override
            public void redo() {
                redo.run();
            }
        };
    }
}
