package faultline.gui.timeline;

import faultline.robot.MotorSide;
import faultline.world.Command;
import java.util.List;
import java.util.function.Function;

/**
 * The role of a command on the time line.
 *
 * @param lane the lane
 * @param effect the effect of the command
 * @param endings the commands that end the interval which the command begins, first the one that ends no other interval
 *     of a fault; empty if the command is over at once
 * @param inLane returns the same command in another lane, or the command itself if it cannot be there
 */
public record CommandRole(Lane lane, ChangedProperty effect, List<Command> endings, Function<Lane, Command> inLane) {

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

    public static CommandRole of(Command command) {
        return command.match(new Command.CommandCases<>(
                switchSensor -> ofSensor(
                        switchSensor,
                        switchSensor.sensor(),
                        ChangedProperty.SWITCH,
                        switchSensor.on() ? List.of() : List.of(new Command.SwitchSensor(switchSensor.sensor(), true)),
                        id -> new Command.SwitchSensor(id, switchSensor.on())),
                configureSensor -> momentOf(configureSensor.sensor().id(), ChangedProperty.SETTING, configureSensor),
                injectFault -> ofSensor(
                        injectFault,
                        injectFault.sensor(),
                        ChangedProperty.FAULT,
                        List.of(
                                new Command.ClearFault(injectFault.sensor(), injectFault.fault()),
                                new Command.ClearFaults(injectFault.sensor())),
                        id -> new Command.InjectFault(id, injectFault.fault())),
                clearFault -> momentOf(clearFault.sensor(), ChangedProperty.FAULT, clearFault),
                clearFaults -> momentOf(clearFaults.sensor(), ChangedProperty.FAULT, clearFaults),
                CommandRole::ofMotorFault,
                clearMotorFault ->
                        moment(new Lane.MotorLane(clearMotorFault.motor()), ChangedProperty.FAULT, clearMotorFault),
                clearMotorFaults ->
                        moment(new Lane.MotorLane(clearMotorFaults.motor()), ChangedProperty.FAULT, clearMotorFaults),
                moveObstacle -> moment(Lane.OTHER, ChangedProperty.OBSTACLE, moveObstacle),
                placeObstacle -> moment(Lane.OTHER, ChangedProperty.OBSTACLE, placeObstacle),
                removeObstacle -> moment(Lane.OTHER, ChangedProperty.OBSTACLE, removeObstacle),
                setPlatform -> moment(Lane.OTHER, ChangedProperty.SETTING, setPlatform),
                configureController -> moment(Lane.OTHER, ChangedProperty.SETTING, configureController)));
    }

    private static CommandRole ofMotorFault(Command.InjectMotorFault command) {
        MotorSide side = command.motor();
        return new CommandRole(
                new Lane.MotorLane(side),
                ChangedProperty.FAULT,
                List.of(new Command.ClearMotorFault(side, command.fault()), new Command.ClearMotorFaults(side)),
                other -> other instanceof Lane.MotorLane motors
                        ? new Command.InjectMotorFault(motors.side(), command.fault())
                        : command);
    }

    /** Returns whether a command changes settings of the controller, of a sensor or of the platform. */
    public static boolean isSettingChange(Command command) {
        return of(command).effect == ChangedProperty.SETTING;
    }

    /** Returns whether the command adds a fault. */
    public boolean isFaultStart() {
        return effect == ChangedProperty.FAULT && !endings.isEmpty();
    }

    private static CommandRole moment(Lane lane, ChangedProperty effect, Command command) {
        return new CommandRole(lane, effect, List.of(), other -> command);
    }

    private static CommandRole momentOf(String sensor, ChangedProperty effect, Command command) {
        return moment(new Lane.SensorLane(sensor), effect, command);
    }

    /** Returns the role of a command about a sensor, of which {@code copy} makes one about another sensor. */
    private static CommandRole ofSensor(
            Command command,
            String sensor,
            ChangedProperty effect,
            List<Command> endings,
            Function<String, Command> copy) {
        return new CommandRole(
                new Lane.SensorLane(sensor),
                effect,
                endings,
                lane -> lane instanceof Lane.SensorLane other ? copy.apply(other.id()) : command);
    }
}
