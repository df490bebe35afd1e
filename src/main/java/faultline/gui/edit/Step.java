package faultline.gui.edit;

import faultline.world.Command;
import java.util.List;

/**
 * One command of an edit and what takes it back.
 *
 * @param redo the command
 * @param undo the commands, in order, that restore what it changed
 */
record Step(Command redo, List<Command> undo) {

    Step {
        undo = List.copyOf(undo);
    }

    /** Whether the command left all as it was. */
    boolean isNothing() {
        return undo.equals(List.of(redo));
    }

    /** What the command is about: two steps of one hand about the same make one. */
    Object about() {
        return redo instanceof Command.MoveObstacle move ? new About("move", move.obstacle())
                : redo instanceof Command.PutObstacle put ? new About("put", put.obstacle().id())
                : redo instanceof Command.TuneSensor tune ? new About("tune", tune.sensor().id())
                : redo instanceof Command.SetPlatform ? new About("platform", "") : redo;
    }

    private record About(String what, String id) {
    }

    /** Whether a user who gives such commands in quick succession means one edit: nudges, and a spinner that is held. */
    static boolean repeats(Command command) {
        return command instanceof Command.MoveObstacle || command instanceof Command.TuneSensor || command instanceof Command.SetPlatform;
    }

    /** This step and a later one about the same. */
    Step then(Step later) {
        return new Step(later.redo, undo);
    }
}
