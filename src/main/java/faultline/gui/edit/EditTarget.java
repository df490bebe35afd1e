package faultline.gui.edit;

import faultline.world.Command;

/**
 * The part of the world that a command changes. Two commands of one edit with equal targets are merged into one.
 *
 * @param kind the kind of change
 * @param subject the id of what is changed, or the command itself if such commands are never merged
 * @param repeatable whether commands in quick succession are one edit, as nudges or a spinner held down are
 */
record EditTarget(String kind, Object subject, boolean repeatable) {

    private static final Command.SetupVisitor<EditTarget> FINDER = new Command.SetupVisitor<>() {
        @Override
        public EditTarget visitTimed(Command command) {
            return new EditTarget("single", command, false);
        }

        @Override
        public EditTarget visit(Command.ConfigureSensor command) {
            return new EditTarget("configure", command.sensor().id(), true);
        }

        @Override
        public EditTarget visit(Command.MoveObstacle command) {
            return new EditTarget("move", command.obstacle(), true);
        }

        @Override
        public EditTarget visit(Command.PlaceObstacle command) {
            return new EditTarget("place", command.obstacle().id(), false);
        }

        @Override
        public EditTarget visit(Command.RemoveObstacle command) {
            return visitTimed(command);
        }

        @Override
        public EditTarget visit(Command.SetPlatform command) {
            return new EditTarget("platform", "", true);
        }

        @Override
        public EditTarget visit(Command.ConfigureController command) {
            return new EditTarget("controller", "", true);
        }
    };

    /** Returns the target of a command. */
    static EditTarget of(Command command) {
        return command.accept(FINDER);
    }
}
