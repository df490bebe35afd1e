package faultline.engine;

import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Refusal;
import java.util.HashSet;
import java.util.Set;

/**
 * The commands of the timeline that are void, because a command from outside has removed the obstacle that they are
 * about. Such a command is refused, but that is no mistake of the timeline.
 */
final class VoidCommands {

    /** The obstacles that commands from outside have removed, unless the timeline has removed them since. */
    private final Set<String> removed = new HashSet<>();

    /** Records that a command from outside has been executed. */
    void executedFromOutside(Command command) {
        if (command instanceof Command.RemoveObstacle removal) {
            removed.add(removal.obstacle());
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
