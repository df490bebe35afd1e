package faultline.gui.document;

import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.robot.RobotSpec;
import faultline.scenario.Scenario;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.List;

/**
 * A change of the id of a sensor, which keeps its place in the robot's list.
 *
 * @param before the id before
 * @param after the id after, which no other sensor has
 */
public record SensorRename(String before, String after) {

    /** Returns the change back. */
    public SensorRename inverse() {
        return new SensorRename(after, before);
    }

    /** Returns the id of a sensor after this change, given the one before. */
    String rename(String id) {
        return id.equals(before) ? after : id;
    }

    /** Returns a scenario with the new id in the robot and in all commands of the timeline. */
    Scenario rename(Scenario scenario) {
        SimulationSetup setup = scenario.setup();
        RobotSpec robot = setup.robot()
                .withSensors(setup.robot().sensors().stream().map(this::rename).toList());
        List<TimedCommand> timeline = setup.timeline().stream()
                .map(timed -> new TimedCommand(timed.time(), rename(timed.command())))
                .toList();
        return scenario.withSetup(setup.withRobot(robot).withTimeline(timeline));
    }

    private SensorSpec rename(SensorSpec sensor) {
        return sensor.withId(rename(sensor.id()));
    }

    /** Returns a command about the sensor with its new id; a command about something else itself. */
    public Command rename(Command command) {
        return command instanceof Command.SensorCommand about
                        && !after.equals(before)
                        && about.sensorId().equals(before)
                ? about.withSensorId(after)
                : command;
    }

    /**
     * Returns the result of a command about the sensor with the new id in the command and in what undoes it; the result
     * of a command about something else itself.
     */
    public CommandResult rename(CommandResult result) {
        Command command = rename(result.command());
        if (command == result.command()) {
            return result;
        }
        return result.refusal()
                .<CommandResult>map(reason -> new CommandResult.Refused(result.tick(), command, reason))
                .orElseGet(() -> new CommandResult.Executed(
                        result.tick(),
                        command,
                        result.inverse().stream().map(this::rename).toList()));
    }
}
