package faultline.gui.edit;

import faultline.control.ControllerSpec;
import faultline.gui.change.ObstacleOrigins;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;

/**
 * The commands that were sent to the run and have no effect in a frame yet, and what the robot, its controller and the
 * obstacles will be after them. The run answers a command when a frame that shows its effect is published, so commands
 * that have been answered are forgotten with the next frame, whether they were executed or refused. Event dispatch
 * thread only.
 */
public final class PendingEdits {

    private final List<Batch> batches = new ArrayList<>();
    private RobotSpec shownRobot = RobotSpec.DEFAULT;
    private ControllerSpec shownController = ControllerSpec.WallFollowing.DEFAULT;

    /** Commands that were sent together. */
    private static final class Batch {
        private final List<Command> commands;
        private boolean answered;

        Batch(List<Command> commands) {
            this.commands = List.copyOf(commands);
        }
    }

    /** Adds commands that are being sent; the returned callback must be called when the run has answered them. */
    Runnable add(List<Command> commands) {
        Batch batch = new Batch(commands);
        batches.add(batch);
        return () -> batch.answered = true;
    }

    /** Forgets all commands, because the run that they were sent to has ended. */
    void clear() {
        batches.clear();
    }

    /** Takes the robot of the newest frame of the run. */
    public void setRobot(RobotSpec robot) {
        shownRobot = robot;
        batches.removeIf(batch -> batch.answered);
    }

    /** Returns the robot as it will be after all pending commands. */
    public RobotSpec robot() {
        return applied(
                shownRobot, (command, robot) -> command.keepingSwitch(robot).appliedTo(robot));
    }

    /** Takes the controller's settings of the newest frame of the run. */
    public void setController(ControllerSpec controller) {
        shownController = controller;
    }

    /** Returns the controller's settings as they will be after all pending commands. */
    public ControllerSpec controller() {
        return applied(
                shownController,
                (command, controller) ->
                        command instanceof Command.ConfigureController change ? change.controller() : controller);
    }

    /** Returns an obstacle of the newest frame as it will be after all pending commands that move or replace it. */
    public Obstacle expected(Obstacle obstacle) {
        return applied(obstacle, PendingEdits::changed);
    }

    /** Returns obstacles of the newest frame as they will be after all pending commands, without removed ones. */
    public List<Obstacle> expected(List<Obstacle> obstacles) {
        Map<String, List<Command>> commands = commandsByObstacle();
        return obstacles.stream()
                .flatMap(obstacle -> expected(obstacle, commands.getOrDefault(obstacle.id(), List.of())).stream())
                .toList();
    }

    /** Returns the pending commands about obstacles by the id of the obstacle, each list in its order. */
    private Map<String, List<Command>> commandsByObstacle() {
        return applied(new HashMap<>(), (command, byObstacle) -> {
            ObstacleOrigins.subject(command).ifPresent(id -> byObstacle
                    .computeIfAbsent(id, first -> new ArrayList<>())
                    .add(command));
            return byObstacle;
        });
    }

    /** Returns an obstacle after the commands about it; empty if it has been removed and not placed again. */
    private static Optional<Obstacle> expected(Obstacle obstacle, List<Command> commands) {
        Obstacle expected = obstacle;
        boolean removed = false;
        for (Command command : commands) {
            removed =
                    command instanceof Command.RemoveObstacle || removed && !(command instanceof Command.PlaceObstacle);
            expected = changed(command, expected);
        }
        return removed ? Optional.empty() : Optional.of(expected);
    }

    /** Returns whether a pending command moves an obstacle. */
    public boolean isMoved(String id) {
        return applied(
                false,
                (command, moved) -> moved
                        || command instanceof Command.MoveObstacle move
                                && move.obstacle().equals(id));
    }

    private static Obstacle changed(Command command, Obstacle obstacle) {
        if (command instanceof Command.PlaceObstacle place) {
            return place.obstacle().id().equals(obstacle.id()) ? place.obstacle() : obstacle;
        }
        return command instanceof Command.MoveObstacle move && move.obstacle().equals(obstacle.id())
                ? obstacle.withPose(move.pose())
                : obstacle;
    }

    private <T> T applied(T shown, BiFunction<Command, T, T> effect) {
        T expected = shown;
        for (Batch batch : batches) {
            for (Command command : batch.commands) {
                expected = effect.apply(command, expected);
            }
        }
        return expected;
    }
}
