package faultline.gui.change;

import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** Finds the events of a run, each with what undoes it in the present run, by what the run has executed. */
final class EventIndex {

    private final Map<Key, List<ExecutedChange>> events;

    /** What two different events rarely have in common, and what is fast to compare. */
    private record Key(long tick, Command command, int inverseSize) {
        static Key of(CommandResult executed) {
            return new Key(
                    executed.tick(), executed.command(), executed.inverse().size());
        }
    }

    /** Takes all changes of a run. */
    EventIndex(Collection<ExecutedChange> changes) {
        events = changes.stream()
                .filter(ExecutedChange::isEvent)
                .collect(Collectors.groupingBy(change -> Key.of(change.executed())));
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
