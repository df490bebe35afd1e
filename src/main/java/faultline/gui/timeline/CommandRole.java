package faultline.gui.timeline;

import faultline.robot.MotorSide;
import faultline.world.Command;
import java.util.List;
import java.util.function.Function;

/**
 * The role of a command on the time line. Each kind of command has a separate visitor method here, so that a new one
 * does not compile without a role.
 *
 * @param lane the lane
 * @param effect the effect of the command
 * @param endings the commands that end the interval which the command begins, first the one that ends no other
 *     interval; empty if the command is over at once
 * @param inLane returns the same command in another lane, or the command itself if it cannot be there
 */
public record CommandRole(Lane lane, ChangedProperty effect, List<Command> endings, Function<Lane, Command> inLane) {

    private static final Command.Visitor<CommandRole> FINDER = new Finder();

    /** The property that a command changes. */
    public enum ChangedProperty {
        /** The faults of a sensor or of motors. */
        FAULT,
        /** Whether a sensor is on. */
        SWITCH,
        /** Settings of the controller, of a sensor or of the platform. */
        SETTING,
        /** An obstacle. */
        OBSTACLE
    }

    /** Returns the role of a command. */
    public static CommandRole of(Command command) {
        return command.accept(FINDER);
    }

    /** Returns whether a command changes settings of the controller, of a sensor or of the platform. */
    public static boolean isSettingChange(Command command) {
        return of(command).effect == ChangedProperty.SETTING;
    }

    /** Returns whether the command adds a fault. */
    boolean isFaultStart() {
        return effect == ChangedProperty.FAULT && !endings.isEmpty();
    }

    private static CommandRole moment(Lane lane, ChangedProperty effect, Command command) {
        return new CommandRole(lane, effect, List.of(), other -> command);
    }

    /** Returns a function that changes the sensor of a command, which must be in the lane of a sensor. */
    private static Function<Lane, Command> bySensor(Command command, Function<String, Command> copy) {
        return lane -> lane instanceof Lane.SensorLane sensor ? copy.apply(sensor.id()) : command;
    }

    private static final class Finder implements Command.Visitor<CommandRole> {

        @Override
        public CommandRole visit(Command.SwitchSensor command) {
            String sensor = command.sensor();
            return new CommandRole(
                    new Lane.SensorLane(sensor),
                    ChangedProperty.SWITCH,
                    command.on() ? List.of() : List.of(new Command.SwitchSensor(sensor, true)),
                    bySensor(command, id -> new Command.SwitchSensor(id, command.on())));
        }

        @Override
        public CommandRole visit(Command.InjectFault command) {
            String sensor = command.sensor();
            return new CommandRole(
                    new Lane.SensorLane(sensor),
                    ChangedProperty.FAULT,
                    List.of(new Command.ClearFault(sensor, command.fault()), new Command.ClearFaults(sensor)),
                    bySensor(command, id -> new Command.InjectFault(id, command.fault())));
        }

        @Override
        public CommandRole visit(Command.ClearFault command) {
            return moment(new Lane.SensorLane(command.sensor()), ChangedProperty.FAULT, command);
        }

        @Override
        public CommandRole visit(Command.ClearFaults command) {
            return moment(new Lane.SensorLane(command.sensor()), ChangedProperty.FAULT, command);
        }

        @Override
        public CommandRole visit(Command.InjectMotorFault command) {
            MotorSide side = command.motor();
            return new CommandRole(
                    new Lane.MotorLane(side),
                    ChangedProperty.FAULT,
                    List.of(new Command.ClearMotorFault(side, command.fault()), new Command.ClearMotorFaults(side)),
                    other -> other instanceof Lane.MotorLane motors
                            ? new Command.InjectMotorFault(motors.side(), command.fault())
                            : command);
        }

        @Override
        public CommandRole visit(Command.ClearMotorFault command) {
            return moment(new Lane.MotorLane(command.motor()), ChangedProperty.FAULT, command);
        }

        @Override
        public CommandRole visit(Command.ClearMotorFaults command) {
            return moment(new Lane.MotorLane(command.motor()), ChangedProperty.FAULT, command);
        }

        @Override
        public CommandRole visit(Command.ConfigureSensor command) {
            return moment(new Lane.SensorLane(command.sensor().id()), ChangedProperty.SETTING, command);
        }

        @Override
        public CommandRole visit(Command.SetPlatform command) {
            return moment(Lane.OTHER, ChangedProperty.SETTING, command);
        }

        @Override
        public CommandRole visit(Command.ConfigureController command) {
            return moment(Lane.OTHER, ChangedProperty.SETTING, command);
        }

        @Override
        public CommandRole visit(Command.MoveObstacle command) {
            return moment(Lane.OTHER, ChangedProperty.OBSTACLE, command);
        }

        @Override
        public CommandRole visit(Command.PlaceObstacle command) {
            return moment(Lane.OTHER, ChangedProperty.OBSTACLE, command);
        }

        @Override
        public CommandRole visit(Command.RemoveObstacle command) {
            return moment(Lane.OTHER, ChangedProperty.OBSTACLE, command);
        }
    }
}
