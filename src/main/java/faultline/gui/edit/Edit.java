package faultline.gui.edit;

/** An entry of the undo history. */
sealed interface Edit permits CommandEdit, EventEdit, SetupEdit {

    /** Returns the name that menus show. */
    String name();

    /** Returns whether undoing the edit, which is done, changes something. */
    default boolean isEffective() {
        return true;
    }

    /** Redoes or undoes the edit in the run of a controller. */
    void apply(UndoController controller, boolean redone);
}
