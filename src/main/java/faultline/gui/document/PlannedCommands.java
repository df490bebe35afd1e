package faultline.gui.document;

import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** Finds commands of the timeline of a setup by their ticks. */
final class PlannedCommands {

    private PlannedCommands() {}

    /** Returns the commands from one tick to another, both included, in the order of their execution. */
    static List<Command> between(SimulationSetup setup, long from, long to) {
        return setup.timeline().stream()
                .filter(planned -> isBetween(setup.tickAt(planned.time()), from, to))
                .sorted(Comparator.comparingLong(planned -> setup.tickAt(planned.time())))
                .map(TimedCommand::command)
                .toList();
    }

    private static boolean isBetween(long tick, long from, long to) {
        return from <= tick && tick <= to;
    }

    /**
     * Returns the last tick, not after an executed command, at which an obstacle is placed that has the id of the one
     * that the command is about; -1 if there is none.
     */
    static long originTick(SimulationSetup setup, CommandResult result) {
        Optional<String> obstacle = ObstacleOrigins.subject(result.command());
        return setup.timeline().stream()
                .filter(planned -> planned.command() instanceof Command.PlaceObstacle place
                        && Optional.of(place.obstacle().id()).equals(obstacle))
                .mapToLong(planned -> setup.tickAt(planned.time()))
                .filter(tick -> tick <= result.tick())
                .max()
                .orElse(-1);
    }
}
