package faultline.gui.change;

import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Finds the events of a run, each with what undoes it in the present run, by what the run has executed. */
final class EventIndex {

    private final Map<Key, List<ExecutedChange>> events;

    /** What two different events rarely have in common, and what is fast to compare. */
    record Key(long tick, Command command, int inverseSize) {
        static Key of(CommandResult executed) {
            return new Key(
                    executed.tick(), executed.command(), executed.inverse().size());
        }

        Key renamed(Rename rename) {
            return new Key(tick, rename.rename(command), inverseSize);
        }
    }

    /** Takes all changes of a run. */
    EventIndex(Collection<ExecutedChange> changes) {
        events = changes.stream()
                .filter(ExecutedChange::isEvent)
                .collect(Collectors.groupingBy(change -> Key.of(change.executed())));
    }

    /** Lets changes of a run that are the results of an undo refer to the events of their subjects that it undoes. */
    static void linkUndo(List<ExecutedChange> changes, List<CommandResult> undone, List<CommandResult> results) {
        Map<Object, Set<Key>> undoneEvents = events(undone)
                .collect(Collectors.groupingBy(
                        event -> TimelineEvents.subject(event.command()),
                        Collectors.mapping(Key::of, Collectors.toSet())));
        Set<Key> undoing = events(results).map(Key::of).collect(Collectors.toSet());
        changes.replaceAll(change -> change.isEvent() && undoing.contains(Key.of(change.executed()))
                ? change.undoing(undoneEvents.getOrDefault(
                        TimelineEvents.subject(change.executed().command()), Set.of()))
                : change);
    }

    private static Stream<CommandResult> events(List<CommandResult> results) {
        return results.stream().filter(result -> TimelineEvents.isEvent(result.command()));
    }

    /** Returns the result of an event with what undoes it in the present run; another result itself. */
    CommandResult present(CommandResult executed) {
        return events.getOrDefault(Key.of(executed), List.of()).stream()
                .filter(change -> change.executed().equals(executed))
                .map(ExecutedChange::change)
                .findFirst()
                .orElse(executed);
    }
}
