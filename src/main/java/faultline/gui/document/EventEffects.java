package faultline.gui.document;

import faultline.world.Command;
import faultline.world.Command.CommandCases;
import faultline.world.CommandResult;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * What events do to their subject: the switch of a sensor, its faults, or the faults of the motors of a side. The state
 * of a subject is represented by the commands that bring it about.
 */
final class EventEffects {

    private static final CommandCases<Consumer<List<Command>>> CHANGES = new CommandCases<>(
            switchSensor -> state -> {
                state.clear();
                state.add(switchSensor);
            },
            other(),
            inject -> state -> state.add(inject),
            clear -> state -> state.remove(new Command.InjectFault(clear.sensor(), clear.fault())),
            clearAll -> List::clear,
            inject -> state -> state.add(inject),
            clear -> state -> state.remove(new Command.InjectMotorFault(clear.motor(), clear.fault())),
            clearAll -> List::clear,
            other(),
            other(),
            other(),
            other(),
            other());

    private static final CommandCases<Subject> SUBJECTS = new CommandCases<>(
            switchSensor -> new Subject("switch", switchSensor.sensor()),
            other(),
            inject -> new Subject("faults", inject.sensor()),
            clear -> new Subject("faults", clear.sensor()),
            clearAll -> new Subject("faults", clearAll.sensor()),
            inject -> new Subject("motors", inject.motor()),
            clear -> new Subject("motors", clear.motor()),
            clearAll -> new Subject("motors", clearAll.motor()),
            other(),
            other(),
            other(),
            other(),
            other());

    private EventEffects() {}

    /** What an event changes: a property of a sensor or of a side. */
    record Subject(String property, Object part) {}

    private static <C, R> Function<C, R> other() {
        return command -> {
            throw new IllegalArgumentException("no event: " + command);
        };
    }

    /** Returns what an event changes. */
    static Subject subject(Command event) {
        return event.match(SUBJECTS);
    }

    /** Returns successive events of one subject without those that lead back to a state that it had before them. */
    static List<CommandResult> withoutDetours(List<CommandResult> events) {
        List<CommandResult> kept = new ArrayList<>();
        List<List<Command>> states = new ArrayList<>();
        List<Command> state = new ArrayList<>();
        events.get(0).inverse().forEach(command -> command.match(CHANGES).accept(state));
        states.add(List.copyOf(state));
        for (CommandResult event : events) {
            event.command().match(CHANGES).accept(state);
            int before = states.indexOf(state);
            if (before < 0) {
                states.add(List.copyOf(state));
                kept.add(event);
            } else {
                states.subList(before + 1, states.size()).clear();
                kept.subList(before, kept.size()).clear();
            }
        }
        return kept;
    }
}
