package faultline.gui.edit;

import faultline.world.Command;
import java.util.List;

/**
 * One command of an edit and what takes it back.
 *
 * @param redo the command
 * @param undo the commands, in order, that restore what it changed
 */
record ReversibleCommand(Command redo, List<Command> undo) {

    ReversibleCommand {
        undo = List.copyOf(undo);
    }

    /** Whether the command left all as it was. */
    boolean isNoOp() {
        return undo.equals(List.of(redo));
    }

    /** What the command is about: two steps of one hand about the same make one. */
    Object target() {
        return redo instanceof Command.MoveObstacle move
                ? new EditTarget("move", move.obstacle())
                : redo instanceof Command.PlaceObstacle put
                        ? new EditTarget("put", put.obstacle().id())
                        : redo instanceof Command.ConfigureSensor tune
                                ? new EditTarget("tune", tune.sensor().id())
                                : redo instanceof Command.SetPlatform ? new EditTarget("platform", "") : redo;
    }

    private record EditTarget(String kind, String id) {}

    /**
     * Whether a user who gives such commands in quick succession means one edit: nudges, and a spinner that is held.
     */
    static boolean isRepeatable(Command command) {
        return command instanceof Command.MoveObstacle
                || command instanceof Command.ConfigureSensor
                || command instanceof Command.SetPlatform;
    }

    /** This step and a later one about the same. */
    ReversibleCommand mergedWith(ReversibleCommand later) {
        return new ReversibleCommand(later.redo, undo);
    }
}
