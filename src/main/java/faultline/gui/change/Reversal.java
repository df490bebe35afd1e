package faultline.gui.change;

import faultline.world.Command;
import java.util.function.Consumer;

/**
 * What the undo of a command restores in a setup.
 *
 * @param restored restores it
 * @param earlier what the undo of an earlier command with the same inverse restores, null for none
 */
record Reversal(Consumer<EditedSetup> restored, Reversal earlier) {

    /** A command that undoes another one; the origin of its obstacle, null if it is about something else. */
    record UndoCommand(Command command, ObstacleOrigins.Origin origin) {
        UndoCommand renamed(Rename rename) {
            return new UndoCommand(rename.rename(command), origin == null ? null : origin.renamed(rename));
        }
    }

    Reversal after(Reversal others) {
        return new Reversal(restored, earlier == null ? others : earlier.after(others));
    }

    Reversal renamed(Rename rename) {
        return new Reversal(
                setup -> setup.changeBefore(rename, restored), earlier == null ? null : earlier.renamed(rename));
    }
}
