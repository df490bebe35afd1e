package faultline.gui.change;

import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Clearance;
import faultline.world.Command;
import faultline.world.Command.CommandCases;
import faultline.world.CommandResult;
import faultline.world.Obstacle;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** What executed commands change in a setup: its obstacles, its robot and its controller. */
public final class EditedSetup {

    private static final Consumer<EditedSetup> NOTHING = setup -> {};

    /** How far an obstacle is moved away from the robot that it touches, metres: nobody sees it. */
    private static final double GAP = 1e-6;

    private final SimulationSetup base;
    private final EditedObstacles obstacles;
    private RobotSpec robot;
    private ControllerSpec controller;

    private EditedSetup(SimulationSetup base, EditedObstacles obstacles, RobotSpec robot, ControllerSpec controller) {
        this.base = base;
        this.obstacles = obstacles.copy();
        this.robot = robot;
        this.controller = controller;
    }

    /** Takes the robot and the controller of a setup, and a copy of its obstacles. */
    EditedSetup(SimulationSetup base, EditedObstacles obstacles) {
        this(base, obstacles, base.robot(), base.controller());
    }

    EditedSetup copy() {
        return new EditedSetup(base, obstacles, robot, controller);
    }

    EditedObstacles obstacles() {
        return obstacles;
    }

    /** Replaces the obstacles by those of a setup with the same obstacles before its edits. */
    void takeObstacles(EditedSetup other) {
        obstacles.take(other.obstacles);
    }

    RobotSpec robot() {
        return robot;
    }

    /**
     * Returns the edited setup with a timeline. Changes that leave no room for the robot at its start pose are omitted;
     * an obstacle that only touches it there, as after a drag against the robot, is moved away by a micrometre.
     */
    SimulationSetup withTimeline(List<TimedCommand> timeline) {
        EditedSetup result = copy();
        result.clearStartPose();
        return base.withWorld(result.obstacles.world())
                .withRobot(result.robot)
                .withController(controller)
                .withTimeline(timeline);
    }

    /** Reverts, one by one, the changes that obstruct the start pose. */
    private void clearStartPose() {
        Optional<String> obstruction = findObstruction();
        while (obstruction.isPresent() && revertChange(obstruction.get())) {
            obstruction = findObstruction();
        }
    }

    private Optional<String> findObstruction() {
        return Clearance.findObstruction(obstacles.world(), robot, base.start());
    }

    private boolean revertChange(String id) {
        if (obstacles.changedAtStart(id).filter(this::moveAway).isPresent() || obstacles.revertAtStart(id)) {
            return true;
        }
        RobotSpec smaller =
                robot.withPlatform(base.robot().length(), base.robot().width(), robot.speed());
        boolean changed = !smaller.equals(robot);
        robot = smaller;
        return changed;
    }

    /** Moves an obstacle away from the robot at its start; returns false if that does not leave room for the robot. */
    private boolean moveAway(Obstacle obstacle) {
        Pose pose = obstacle.pose();
        // One of the normals of the robot's sides is at most 45 degrees from that of the contact.
        for (int side = 0; side < 4; side++) {
            Vector2 normal = Vector2.direction(base.start().heading() + side * Math.PI / 2);
            Obstacle moved = obstacle.withPose(pose.withPosition(pose.position().plus(normal.times(GAP))));
            if (leavesRoom(moved)) {
                obstacles.changeAtStart(moved);
                return true;
            }
        }
        return false;
    }

    private boolean leavesRoom(Obstacle obstacle) {
        WorldSpec world = base.world();
        WorldSpec alone = new WorldSpec(world.width(), world.height(), false, world.maxMoving(), List.of(obstacle));
        return Clearance.findObstruction(alone, robot, base.start()).isEmpty();
    }

    /** Returns whether the setup has what a command is about. */
    boolean hasSubjectOf(CommandResult result) {
        boolean places = result.command() instanceof Command.PlaceObstacle;
        return SensorReference.isOn(robot, result.command())
                && (places
                        || ObstacleOrigins.subject(result.command())
                                .filter(id -> !obstacles.contains(result.tick(), id))
                                .isEmpty());
    }

    /** Returns what makes the change of a command. */
    static Consumer<EditedSetup> change(CommandResult result) {
        return result.effect()
                .match(CommandCases.ofSetup(
                        timed -> NOTHING,
                        configureSensor -> setup -> setup.configure(configureSensor),
                        move -> setup -> setup.obstacles.move(result.tick(), move.obstacle(), move.pose()),
                        place -> setup -> setup.obstacles.place(result.tick(), place.obstacle()),
                        remove -> setup -> setup.obstacles.remove(result.tick(), remove.obstacle()),
                        setPlatform -> setup -> setup.robot = setPlatform.appliedTo(setup.robot),
                        configure -> setup -> setup.controller = configure.controller()));
    }

    /**
     * Returns the result of an edit, all of whose sensors are on if it is about settings of a sensor. The run leaves
     * the switch as it is at the tick, so an edit and what undoes it would differ if the sensor is switched in between.
     */
    public static CommandResult withoutSwitch(CommandResult result) {
        return result.command() instanceof Command.ConfigureSensor
                        && result.refusal().isEmpty()
                ? new CommandResult.Executed(
                        result.tick(),
                        withoutSwitch(result.command()),
                        result.inverse().stream()
                                .map(EditedSetup::withoutSwitch)
                                .toList())
                : result;
    }

    private static Command withoutSwitch(Command command) {
        return command instanceof Command.ConfigureSensor configure
                ? new Command.ConfigureSensor(configure.sensor().withOn(true))
                : command;
    }

    private void configure(Command.ConfigureSensor command) {
        robot = command.keepingSwitch(robot).appliedTo(robot);
    }

    /** Makes a change that is about the ids from before a change of an id that the setup has. */
    void changeBefore(Rename rename, Consumer<EditedSetup> change) {
        rename(rename.inverse());
        change.accept(this);
        rename(rename);
    }

    private void rename(Rename rename) {
        obstacles.rename(rename);
        robot = rename.rename(robot);
    }

    /** Returns what restores, after a command, what the setup has now. */
    Consumer<EditedSetup> reversal(CommandResult result) {
        RobotSpec robotNow = robot;
        ControllerSpec controllerNow = controller;
        return result.command()
                .match(CommandCases.ofSetup(
                        timed -> NOTHING,
                        configureSensor -> {
                            SensorSpec sensor = robotNow.sensor(
                                            configureSensor.sensor().id())
                                    .orElseThrow();
                            return setup -> setup.configure(new Command.ConfigureSensor(sensor));
                        },
                        move -> restoring(obstacles.moveBack(result.tick(), move.obstacle())),
                        place -> restoring(obstacles.reversal(
                                result.tick(), place.obstacle().id())),
                        remove -> restoring(obstacles.reversal(result.tick(), remove.obstacle())),
                        setPlatform -> setup -> setup.robot =
                                setup.robot.withPlatform(robotNow.length(), robotNow.width(), robotNow.speed()),
                        configure -> setup -> setup.controller = controllerNow));
    }

    private static Consumer<EditedSetup> restoring(Consumer<EditedObstacles> reversal) {
        return setup -> reversal.accept(setup.obstacles);
    }
}
