package faultline.gui.change;

import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.List;
import java.util.Optional;

/**
 * A command of an edit that is undone or redone after the timeline has changed the same thing. The run keeps what the
 * timeline has made of it, as a run of the scenario would; what the scenario has from the start changes all the same.
 *
 * @param inRun the command that the run executes, null for none
 * @param inScenario the command that changes the scenario, with what undoes it there, at the tick of the edit; null for
 *     the command of the run
 */
public record LaterChange(Command inRun, CommandResult inScenario) {

    /** Returns a change that is the same in the run and in the scenario. */
    public static LaterChange same(Command command) {
        return new LaterChange(command, null);
    }

    /**
     * Returns the change that an edit makes after commands of the timeline, given its command, as if it were executed
     * at the tick of the edit, and what undoes it. Empty if none of the others is about the same thing.
     */
    public static Optional<LaterChange> after(List<Command> planned, CommandResult edit) {
        Command command = edit.command();
        List<Command> others =
                planned.stream().filter(other -> isAboutSame(other, command)).toList();
        Command inRun = command;
        for (Command other : others) {
            inRun = inRun == null ? null : replay(inRun, other);
        }
        return others.isEmpty() ? Optional.empty() : Optional.of(new LaterChange(inRun, edit));
    }

    /** Returns the result in the scenario, given that in the run. */
    public CommandResult resultInScenario(CommandResult result) {
        return inScenario == null || result.refusal().isPresent() ? result : inScenario;
    }

    private static boolean isAboutSame(Command other, Command command) {
        Optional<String> obstacle = ObstacleOrigins.subject(command);
        return obstacle.isPresent()
                ? ObstacleOrigins.subject(other).equals(obstacle)
                : other.getClass() == command.getClass()
                        && SensorReference.in(other).equals(SensorReference.in(command));
    }

    /** Returns a command after another one that follows it, null if only the other one has an effect. */
    private static Command replay(Command command, Command other) {
        if (other instanceof Command.MoveObstacle move && command instanceof Command.PlaceObstacle place) {
            return new Command.PlaceObstacle(place.obstacle().withPose(move.pose()));
        }
        return other instanceof Command.MoveObstacle && command instanceof Command.RemoveObstacle ? command : null;
    }
}
