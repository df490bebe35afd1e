package faultline.gui.edit;

import faultline.world.Command;
import java.util.List;

/**
 * A command of an edit and its inverse.
 *
 * @param redo the command
 * @param undo the commands, in order, that restore what it changed
 */
record ReversibleCommand(Command redo, List<Command> undo) {

    ReversibleCommand {
        undo = List.copyOf(undo);
    }

    /** Returns whether the command changed nothing. */
    boolean isNoOp() {
        return undo.equals(List.of(redo));
    }

    /** Returns the target of the command. */
    EditTarget target() {
        return EditTarget.of(redo);
    }

    /** Returns one step in place of this one and a later one with the same target. */
    ReversibleCommand mergedWith(ReversibleCommand later) {
        return new ReversibleCommand(later.redo, undo);
    }
}
