package faultline.gui.edit;

/** An entry of the undo history. */
sealed interface Edit permits CommandEdit, SetupEdit {

    /** Returns the name that menus show. */
    String name();

    /** Redoes or undoes the edit in the run of a controller. */
    void apply(UndoController controller, boolean redone);
}
