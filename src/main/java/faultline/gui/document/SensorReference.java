package faultline.gui.document;

import faultline.robot.RobotSpec;
import faultline.world.Command;
import faultline.world.Command.CommandCases;
import java.util.Optional;
import java.util.function.Function;

/** Finds the sensor that a command is about. */
public final class SensorReference {

    private static final CommandCases<Optional<String>> FINDER = new CommandCases<>(
            switchSensor -> Optional.of(switchSensor.sensor()),
            configureSensor -> Optional.of(configureSensor.sensor().id()),
            injectFault -> Optional.of(injectFault.sensor()),
            clearFault -> Optional.of(clearFault.sensor()),
            clearFaults -> Optional.of(clearFaults.sensor()),
            none(),
            none(),
            none(),
            none(),
            none(),
            none(),
            none(),
            none());

    private SensorReference() {}

    private static <C> Function<C, Optional<String>> none() {
        return command -> Optional.empty();
    }

    /** Returns whether a robot has the sensor that a command is about, or the command is about something else. */
    static boolean isOn(RobotSpec robot, Command command) {
        return in(command).map(id -> robot.indexOf(id) >= 0).orElse(true);
    }

    /** Returns the id of the sensor that a command is about; empty if it is about something else. */
    public static Optional<String> in(Command command) {
        return command.match(FINDER);
    }
}
