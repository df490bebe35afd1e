package faultline.engine.trace;

import faultline.io.MessageText;

/** The cell of a column with a name that a controller gives and that rarely changes, as of its state. */
final class NameCell {

    private String name = "";
    private String cell = "";

    /** Returns the cell of a name; the same object while the name stays the same. */
    String of(String newName) {
        if (!newName.equals(name)) {
            name = newName;
            cell = MessageText.csvCell(newName);
        }
        return cell;
    }
}
