package faultline.gui.change;

import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.robot.RobotSpec;
import faultline.scenario.Scenario;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Command.CommandCases;
import faultline.world.CommandResult;
import faultline.world.Obstacle;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/**
 * A change of the id of a sensor or an obstacle, which keeps its place in the list. One that has been removed and had
 * the new id gets the one that is free now, so that commands about the two remain different.
 *
 * @param kind what has another id
 * @param before the id before
 * @param after the id after, which no other one has
 */
public record Rename(Renamed kind, String before, String after) {

    enum Renamed {
        SENSOR,
        OBSTACLE
    }

    /** Returns a change of the id of a sensor. */
    public static Rename ofSensor(String before, String after) {
        return new Rename(Renamed.SENSOR, before, after);
    }

    /** Returns a change of the id of an obstacle. */
    public static Rename ofObstacle(String before, String after) {
        return new Rename(Renamed.OBSTACLE, before, after);
    }

    public boolean isOfSensor() {
        return kind == Renamed.SENSOR;
    }

    /** Returns the change back. */
    public Rename inverse() {
        return new Rename(kind, after, before);
    }

    /** Returns the changes that lead back, in order. */
    public static List<Rename> inverse(List<Rename> renames) {
        List<Rename> result = new ArrayList<>(renames);
        Collections.reverse(result);
        result.replaceAll(Rename::inverse);
        return result;
    }

    /** Returns an id after this change, given the one before. */
    public String rename(String id) {
        if (id.equals(before)) {
            return after;
        }
        return id.equals(after) ? before : id;
    }

    /** Returns the id of an obstacle after this change, given the one before. */
    public String renameObstacle(String id) {
        return isOfSensor() ? id : rename(id);
    }

    /** Returns a scenario with the new id in the robot or the world and in all commands of the timeline. */
    public Scenario rename(Scenario scenario) {
        return scenario.withSetup(rename(scenario.setup()));
    }

    /** Returns a setup with the new id in the robot or the world and in all commands of the timeline. */
    SimulationSetup rename(SimulationSetup setup) {
        List<TimedCommand> timeline = setup.timeline().stream()
                .map(timed -> new TimedCommand(timed.time(), rename(timed.command())))
                .toList();
        SimulationSetup renamed = setup.withRobot(rename(setup.robot())).withTimeline(timeline);
        return isOfSensor()
                ? renamed
                : renamed.withWorld(setup.world()
                        .withObstacles(setup.world().obstacles().stream()
                                .map(this::rename)
                                .toList()));
    }

    /** Returns a journal with the new id in its setup and in all of its commands. */
    public Journal rename(Journal journal) {
        List<Journal.Entry> entries = journal.entries().stream()
                .map(entry -> new Journal.Entry(entry.tick(), rename(entry.command())))
                .toList();
        return new Journal(rename(journal.setup()), entries, journal.ticks(), journal.decisions());
    }

    /** Returns a robot with the new id. */
    RobotSpec rename(RobotSpec robot) {
        return isOfSensor()
                ? robot.withSensors(robot.sensors().stream().map(this::rename).toList())
                : robot;
    }

    /** Returns a sensor with the id that it has after this change. */
    SensorSpec rename(SensorSpec sensor) {
        return isOfSensor() ? sensor.withId(rename(sensor.id())) : sensor;
    }

    /** Returns an obstacle with the id that it has after this change. */
    Obstacle rename(Obstacle obstacle) {
        String id = renameObstacle(obstacle.id());
        return id.equals(obstacle.id()) ? obstacle : obstacle.withId(id);
    }

    /** Returns a command about what has the new id with that id; a command about something else itself. */
    public Command rename(Command command) {
        Optional<String> id = isOfSensor() ? SensorReference.in(command) : ObstacleOrigins.subject(command);
        if (id.filter(now -> !rename(now).equals(now)).isEmpty()) {
            return command;
        }
        return command instanceof Command.SensorCommand about
                ? about.withSensorId(rename(about.sensorId()))
                : renamed(command);
    }

    private Command renamed(Command aboutObstacle) {
        return aboutObstacle.match(CommandCases.<Command>ofSetup(
                timed -> timed,
                configureSensor -> configureSensor,
                moveObstacle -> new Command.MoveObstacle(rename(moveObstacle.obstacle()), moveObstacle.pose()),
                placeObstacle -> new Command.PlaceObstacle(rename(placeObstacle.obstacle())),
                removeObstacle -> new Command.RemoveObstacle(rename(removeObstacle.obstacle())),
                setPlatform -> setPlatform,
                configureController -> configureController));
    }

    /**
     * Returns the result of a command about what has the new id with that id in the command and in what undoes it; the
     * result of a command about something else itself.
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
                        rename(result.effect()),
                        result.inverse().stream().map(this::rename).toList()));
    }
}
