package faultline.gui.document;

import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.robot.RobotSpec;
import faultline.scenario.Scenario;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Command.CommandCases;
import faultline.world.CommandResult;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

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
        return SensorReference.in(command).filter(before::equals).isEmpty()
                ? command
                : command.match(new CommandCases<>(
                        switchSensor -> new Command.SwitchSensor(after, switchSensor.on()),
                        configureSensor -> new Command.ConfigureSensor(rename(configureSensor.sensor())),
                        injectFault -> new Command.InjectFault(after, injectFault.fault()),
                        clearFault -> new Command.ClearFault(after, clearFault.fault()),
                        clearFaults -> new Command.ClearFaults(after),
                        motors -> motors,
                        motors -> motors,
                        motors -> motors,
                        obstacle -> obstacle,
                        obstacle -> obstacle,
                        obstacle -> obstacle,
                        platform -> platform,
                        controller -> controller));
    }

    /** Returns the result of a command with the new id in the command and in what undoes it. */
    public CommandResult rename(CommandResult result) {
        return result.refusal()
                .<CommandResult>map(
                        reason -> new CommandResult.Refused(result.tick(), rename(result.command()), reason))
                .orElseGet(() -> new CommandResult.Executed(
                        result.tick(),
                        rename(result.command()),
                        result.inverse().stream().map(this::rename).toList()));
    }

    /**
     * Returns what a sensor is called in a newer list of all ids: its id, or the new one if the only difference between
     * the lists is another id at its place; empty if there is no such sensor.
     */
    public static Optional<String> follow(String id, List<String> ids, List<String> newer) {
        if (newer.contains(id)) {
            return Optional.of(id);
        }
        int place = ids.indexOf(id);
        boolean renamed = place >= 0
                && newer.size() == ids.size()
                && IntStream.range(0, ids.size())
                        .allMatch(i -> i == place || ids.get(i).equals(newer.get(i)));
        return renamed ? Optional.of(newer.get(place)) : Optional.empty();
    }
}
