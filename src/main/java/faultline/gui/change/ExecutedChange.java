package faultline.gui.change;

import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A change of the setup at a tick, and what the run executed for it, null for nothing. Both are the same unless the
 * timeline had changed the same thing; the change then has the tick of an earlier edit that is undone or redone. The
 * change of an event has what undoes it in the present run, which may have another timeline.
 *
 * @param undone the events that this event undoes; empty for none
 */
record ExecutedChange(long tick, CommandResult change, CommandResult executed, Set<EventIndex.Key> undone) {
    /** Creates a change that is not known to undo another one. */
    ExecutedChange(long tick, CommandResult change, CommandResult executed) {
        this(tick, change, executed, Set.of());
    }

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

    /** Returns whether this only undoes events that have no effect in the present run. */
    boolean undoesOnly(Set<EventIndex.Key> withoutEffect) {
        return !undone.isEmpty() && withoutEffect.containsAll(undone);
    }

    /** Returns whether the present run does not execute this, because the events that it undoes have no effect. */
    boolean isUndoWithoutEffectNow() {
        return !undone.isEmpty() && isEventWithoutEffectNow();
    }

    ExecutedChange withChange(CommandResult newChange) {
        return new ExecutedChange(tick, newChange, executed, undone);
    }

    /** Returns this event as one that changes nothing in the present run. */
    ExecutedChange withoutEffect() {
        return withChange(new CommandResult.Executed(change.tick(), change.command(), List.of(change.command())));
    }

    ExecutedChange undoing(Set<EventIndex.Key> events) {
        return new ExecutedChange(tick, change, executed, events);
    }

    ExecutedChange renamed(Rename rename) {
        CommandResult renamed = rename.rename(change);
        return new ExecutedChange(
                tick,
                renamed,
                executed == null ? null : rename.rename(executed),
                undone.stream().map(event -> event.renamed(rename)).collect(Collectors.toSet()));
    }
}
