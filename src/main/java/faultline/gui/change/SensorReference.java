package faultline.gui.change;

import faultline.robot.RobotSpec;
import faultline.world.Command;
import java.util.Optional;

/** Finds the sensor that a command is about. */
public final class SensorReference {

    private SensorReference() {}

    /** Returns whether a robot has the sensor that a command is about, or the command is about something else. */
    public static boolean isOn(RobotSpec robot, Command command) {
        return in(command).map(id -> robot.indexOf(id) >= 0).orElse(true);
    }

    /** Returns the id of the sensor that a command is about; empty if it is about something else. */
    public static Optional<String> in(Command command) {
        return command instanceof Command.SensorCommand about ? Optional.of(about.sensorId()) : Optional.empty();
    }
}
