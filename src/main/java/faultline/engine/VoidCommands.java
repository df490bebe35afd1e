package faultline.engine;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Refusal;
import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * The commands of the timeline that are void, because a command from outside has removed the obstacle that they are
 * about. Such a command is refused, but that is no mistake of the timeline.
 */
final class VoidCommands {

    /**
     * The obstacles that commands from outside have removed, unless they have been returned or the timeline has removed
     * them since.
     */
    private final Set<String> removed = new HashSet<>();

    /**
     * Returns the timeline of a journal's setup without the commands that are void in any case, whether those that
     * place an obstacle are refused or not.
     */
    static List<TimedCommand> removedFrom(Journal journal) {
        SimulationSetup setup = journal.setup();
        List<TimedCommand> timeline = setup.timeline();
        Deque<Journal.Entry> entries = new ArrayDeque<>(journal.entries());
        VoidCommands commands = new VoidCommands();
        Set<Integer> found = new HashSet<>();
        IntStream.range(0, timeline.size())
                .boxed()
                .sorted(Comparator.comparingLong(
                        index -> setup.tickAt(timeline.get(index).time())))
                .forEach(index -> {
                    TimedCommand timed = timeline.get(index);
                    while (!entries.isEmpty() && entries.peek().tick() < setup.tickAt(timed.time())) {
                        commands.executedFromOutside(entries.remove().command());
                    }
                    if (commands.isVoid(timed.command())) {
                        found.add(index);
                    }
                });
        return IntStream.range(0, timeline.size())
                .filter(index -> !found.contains(index))
                .mapToObj(timeline::get)
                .toList();
    }

    /** Records a command of the timeline, and returns whether it is void, whatever its result is. */
    private boolean isVoid(Command command) {
        if (command instanceof Command.PlaceObstacle placement) {
            removed.remove(placement.obstacle().id());
        } else if (command instanceof Command.RemoveObstacle removal) {
            return removed.remove(removal.obstacle());
        }
        return command instanceof Command.MoveObstacle move && removed.contains(move.obstacle());
    }

    /** Records that a command from outside has been executed. */
    void executedFromOutside(Command command) {
        if (command instanceof Command.RemoveObstacle removal) {
            removed.add(removal.obstacle());
        } else if (command instanceof Command.PlaceObstacle placement) {
            removed.remove(placement.obstacle().id());
        }
    }

    /** Records a command of the timeline, and returns whether it is void, given its result. */
    boolean takenFromTimeline(CommandResult result) {
        boolean isVoid = result.refusal()
                .filter(refusal ->
                        refusal.reason() == Refusal.Reason.UNKNOWN_OBSTACLE && removed.contains(refusal.subject()))
                .isPresent();
        if (result.command() instanceof Command.RemoveObstacle removal) {
            removed.remove(removal.obstacle());
        }
        return isVoid;
    }
}
