package faultline.gui.edit;

/** An entry of the undo history. */
sealed interface Edit permits CommandEdit, SetupEdit {

    /** Returns the name that menus show. */
    String name();
}
