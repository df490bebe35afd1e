package faultline.gui.timeline;

import faultline.gui.text.Messages;
import faultline.gui.text.MotorFaultText;
import faultline.robot.MotorSide;
import faultline.world.Command;

/** A lane of the time line. */
public sealed interface Lane {

    /** The lane of everything that is about neither a sensor nor motors. */
    Lane OTHER = new Other();

    /** Returns the name that the window shows. */
    String label();

    /**
     * The lane of a sensor.
     *
     * @param id the id of the sensor
     */
    record OfSensor(String id) implements Lane {
        @Override
        public String label() {
            return id;
        }
    }

    /**
     * The lane of the motors of a side.
     *
     * @param side the side
     */
    record OfMotors(MotorSide side) implements Lane {
        @Override
        public String label() {
            return MotorFaultText.motors(side);
        }
    }

    /** See {@link #OTHER}. */
    record Other() implements Lane {
        @Override
        public String label() {
            return Messages.get("timeline.world");
        }
    }

    /** Returns the lane of a command. */
    static Lane of(Command command) {
        return command.accept(Finder.INSTANCE);
    }

    /** Finds the lane of each kind of command. */
    final class Finder implements Command.Visitor<Lane> {

        private static final Finder INSTANCE = new Finder();

        private Finder() {}

        @Override
        public Lane visit(Command.SwitchSensor command) {
            return new OfSensor(command.sensor());
        }

        @Override
        public Lane visit(Command.ConfigureSensor command) {
            return new OfSensor(command.sensor().id());
        }

        @Override
        public Lane visit(Command.InjectFault command) {
            return new OfSensor(command.sensor());
        }

        @Override
        public Lane visit(Command.ClearFault command) {
            return new OfSensor(command.sensor());
        }

        @Override
        public Lane visit(Command.ClearFaults command) {
            return new OfSensor(command.sensor());
        }

        @Override
        public Lane visit(Command.InjectMotorFault command) {
            return new OfMotors(command.motor());
        }

        @Override
        public Lane visit(Command.ClearMotorFault command) {
            return new OfMotors(command.motor());
        }

        @Override
        public Lane visit(Command.ClearMotorFaults command) {
            return new OfMotors(command.motor());
        }

        @Override
        public Lane visit(Command.MoveObstacle command) {
            return OTHER;
        }

        @Override
        public Lane visit(Command.PlaceObstacle command) {
            return OTHER;
        }

        @Override
        public Lane visit(Command.RemoveObstacle command) {
            return OTHER;
        }

        @Override
        public Lane visit(Command.SetPlatform command) {
            return OTHER;
        }

        @Override
        public Lane visit(Command.ConfigureController command) {
            return OTHER;
        }
    }
}
