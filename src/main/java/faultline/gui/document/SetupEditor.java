package faultline.gui.document;

import faultline.control.ControllerSpec;
import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Clearance;
import faultline.world.Command;
import faultline.world.Command.CommandCases;
import faultline.world.CommandResult;
import faultline.world.Obstacle;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * Applies executed commands to a setup. Changes of obstacles, of the platform, of the controller and of the sensors'
 * settings hold from the start; switching a sensor, injecting a fault and repairing it are added to the timeline at
 * their time. When the run is moved to an earlier tick, the later commands are kept until another one is executed
 * there.
 */
final class SetupEditor {

    private final SimulationSetup base;
    private final List<Journal.Entry> entries = new ArrayList<>();
    /** The number of entries that the run has executed. */
    private int position;
    /**
     * The obstacles by id, null if removed, so that an obstacle that is placed again takes its old position in the
     * order.
     */
    private final Map<String, Obstacle> obstacles;

    private RobotSpec robot;
    private ControllerSpec controller;

    SetupEditor(SimulationSetup base) {
        this.base = base;
        this.obstacles = new LinkedHashMap<>(2 * base.world().obstacles().size());
        reset();
    }

    private void reset() {
        robot = base.robot();
        controller = base.controller();
        obstacles.clear();
        base.world().obstacles().forEach(obstacle -> obstacles.put(obstacle.id(), obstacle));
    }

    /**
     * Applies an executed command. Commands that the run had not executed at that time are dropped, and so is a command
     * about a sensor that has been removed while the run was busy with the command.
     */
    void add(CommandResult result) {
        if (!hasSensorOf(result.command())) {
            return;
        }
        moveTo(result.tick() - 1, position);
        if (position < entries.size()) {
            entries.subList(position, entries.size()).clear();
            reset();
            entries.forEach(entry -> apply(entry.command()));
        }
        entries.add(new Journal.Entry(result.tick(), result.command()));
        position = entries.size();
        apply(result.command());
    }

    /** Follows the run to another tick, where the commands for the next one have been executed. */
    void moveTo(long tick) {
        moveTo(tick + 1, 0);
    }

    private void moveTo(long tick, int from) {
        position = from;
        while (position < entries.size() && entries.get(position).tick() <= tick) {
            position++;
        }
    }

    /** Returns the edited setup. Changes that leave no room for the robot at its start pose are omitted. */
    SimulationSetup setup() {
        SetupEditor result = new SetupEditor(base);
        result.obstacles.putAll(obstacles);
        result.robot = robot;
        result.clearStartPose();
        return base.withWorld(result.world())
                .withRobot(result.robot)
                .withController(controller)
                .withTimeline(timeline());
    }

    /**
     * Returns the timeline with the commands that belong to a time. Two commands of one tick that cancel each other are
     * omitted.
     */
    List<SimulationSetup.TimedCommand> timeline() {
        SetupEditor scratch = new SetupEditor(base);
        List<Journal.Entry> timed = new ArrayList<>();
        for (Journal.Entry entry : entries) {
            if (scratch.apply(entry.command())) {
                continue;
            }
            Optional<Journal.Entry> cancelled = timed.stream()
                    .filter(earlier -> earlier.tick() == entry.tick() && cancels(entry.command(), earlier.command()))
                    .findFirst();
            if (cancelled.isPresent()) {
                timed.remove(cancelled.get());
            } else {
                timed.add(entry);
            }
        }
        List<SimulationSetup.TimedCommand> result = new ArrayList<>(base.timeline());
        timed.forEach(
                entry -> result.add(new SimulationSetup.TimedCommand(base.timeOf(entry.tick()), entry.command())));
        return result;
    }

    private boolean hasSensorOf(Command command) {
        return SensorReference.in(command).filter(id -> robot.indexOf(id) < 0).isEmpty();
    }

    /**
     * Returns an editor of another setup with the executed commands that do not belong to the timeline, except for
     * those about sensors that the other setup lacks.
     */
    SetupEditor rebased(SimulationSetup newBase) {
        SetupEditor result = new SetupEditor(newBase);
        for (int i = 0; i < entries.size(); i++) {
            Command command = entries.get(i).command();
            if (result.hasSensorOf(command) && result.apply(command)) {
                result.entries.add(entries.get(i));
                result.position += i < position ? 1 : 0;
            }
        }
        return result;
    }

    /** Returns the executed commands, including those that are later than the tick of a moved run. */
    List<Journal.Entry> entries() {
        return List.copyOf(entries);
    }

    private static boolean cancels(Command command, Command earlier) {
        if (command instanceof Command.SwitchSensor now && earlier instanceof Command.SwitchSensor before) {
            return now.sensor().equals(before.sensor()) && now.on() != before.on();
        }
        return earlier instanceof Command.InjectFault inject
                        && command.equals(new Command.ClearFault(inject.sensor(), inject.fault()))
                || earlier instanceof Command.InjectMotorFault broken
                        && command.equals(new Command.ClearMotorFault(broken.motor(), broken.fault()));
    }

    /** Reverts, one by one, the changes that obstruct the start pose. */
    private void clearStartPose() {
        Optional<String> obstruction = findObstruction();
        while (obstruction.isPresent() && revertChange(obstruction.get())) {
            obstruction = findObstruction();
        }
    }

    private Optional<String> findObstruction() {
        return Clearance.findObstruction(world(), robot, base.start());
    }

    private boolean revertChange(String id) {
        Obstacle before = base.world().obstacles().stream()
                .filter(obstacle -> obstacle.id().equals(id))
                .findFirst()
                .orElse(null);
        if (obstacles.containsKey(id) && !Objects.equals(before, obstacles.get(id))) {
            obstacles.put(id, before);
            return true;
        }
        RobotSpec smaller =
                robot.withPlatform(base.robot().length(), base.robot().width(), robot.speed());
        boolean changed = !smaller.equals(robot);
        robot = smaller;
        return changed;
    }

    private WorldSpec world() {
        return base.world()
                .withObstacles(
                        obstacles.values().stream().filter(Objects::nonNull).toList());
    }

    /** Applies a command, and returns whether it changes the setup rather than belong to a time of the run. */
    private boolean apply(Command command) {
        return command.match(CommandCases.ofSetup(
                timed -> false,
                configureSensor -> {
                    SensorSpec before =
                            robot.sensor(configureSensor.sensor().id()).orElseThrow();
                    robot = robot.withSensor(configureSensor.sensor().withOn(before.on()));
                    return true;
                },
                moveObstacle -> {
                    obstacles.computeIfPresent(
                            moveObstacle.obstacle(), (id, obstacle) -> obstacle.withPose(moveObstacle.pose()));
                    return true;
                },
                placeObstacle -> {
                    obstacles.put(placeObstacle.obstacle().id(), placeObstacle.obstacle());
                    return true;
                },
                removeObstacle -> {
                    obstacles.replace(removeObstacle.obstacle(), null);
                    return true;
                },
                setPlatform -> {
                    robot = setPlatform.appliedTo(robot);
                    return true;
                },
                configureController -> {
                    controller = configureController.controller();
                    return true;
                }));
    }
}
