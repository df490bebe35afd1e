package faultline.gui.change;

import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A change of the setup at a tick, and what the run executed for it, null for nothing. Both are the same unless the
 * timeline had changed the same thing; the change then has the tick of an earlier edit that is undone or redone. The
 * change of an event has what undoes it in the present run, which may have another timeline.
 */
record ExecutedChange(long tick, CommandResult change, CommandResult executed) {
    /** Returns whether this undoes or redoes a change, and the run has executed nothing for it. */
    boolean isWithoutRun(CommandResult other) {
        return executed == null && commands(change).equals(commands(other));
    }

    private static Set<Command> commands(CommandResult change) {
        return Stream.concat(Stream.of(change.command()), change.inverse().stream())
                .collect(Collectors.toSet());
    }

    boolean isEvent() {
        return TimelineEvents.isEvent(change.command());
    }

    /**
     * Returns whether this is an event that changes nothing in the present run, but did when it was executed. One that
     * did not is no edit, so nobody could undo what it would change in another run.
     */
    boolean isEventWithoutEffectNow() {
        return isEvent() && change.isNoOp() && !executed.isNoOp();
    }

    ExecutedChange withChange(CommandResult newChange) {
        return new ExecutedChange(tick, newChange, executed);
    }

    ExecutedChange renamed(Rename rename) {
        CommandResult renamed = rename.rename(change);
        return new ExecutedChange(tick, renamed, executed == null ? null : rename.rename(executed));
    }
}
