package faultline.gui.change;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.world.Command;
import faultline.world.Command.CommandCases;
import faultline.world.CommandResult;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
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

    /** What ends a part of a state; empty for the switch of a sensor, which another state replaces. */
    private static final CommandCases<Optional<Command>> ENDS = new CommandCases<>(
            switchSensor -> Optional.empty(),
            other(),
            inject -> Optional.of(new Command.ClearFault(inject.sensor(), inject.fault())),
            other(),
            other(),
            inject -> Optional.of(new Command.ClearMotorFault(inject.motor(), inject.fault())),
            other(),
            other(),
            other(),
            other(),
            other(),
            other(),
            other());

    private static final int NO_PLACE = -1;

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
        events.get(0).inverse().forEach(command -> change(state, command));
        states.add(List.copyOf(state));
        for (CommandResult event : events) {
            change(state, event.command());
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

    private static void change(List<Command> state, Command event) {
        event.match(CHANGES).accept(state);
    }

    /**
     * Returns the commands that undo an event after other events of its subject. They lead to the state that the others
     * would have led to without it; after others, faults may be in another order.
     */
    static List<Command> undo(CommandResult event, List<Command> others) {
        List<Command> without = new ArrayList<>();
        event.inverse().forEach(command -> change(without, command));
        List<Command> with = new ArrayList<>(without);
        change(with, event.command());
        for (Command other : others) {
            change(without, other);
            change(with, other);
        }
        List<Command> steps = new ArrayList<>();
        TimelineEvents.difference(with, without)
                .forEach(ended -> ended.match(ENDS).ifPresent(steps::add));
        steps.addAll(TimelineEvents.difference(without, with));
        steps.forEach(step -> change(with, step));
        return others.isEmpty() && !with.equals(without) ? event.inverse() : steps;
    }

    /**
     * Returns when events, in their order, end each of the faults of one subject, seconds; infinity if they do not. The
     * faults are represented by what began them, oldest first.
     */
    static List<Double> ends(List<Command> faults, List<TimedCommand> events) {
        List<Double> ends = new ArrayList<>(Collections.nCopies(faults.size(), Double.POSITIVE_INFINITY));
        List<Command> active = new ArrayList<>(faults);
        // The places of the active faults in the list of ends; faults that begin later have none.
        List<Integer> places = new ArrayList<>();
        faults.forEach(fault -> places.add(places.size()));
        for (TimedCommand event : events) {
            int before = active.size();
            int oldest = indexOfEnded(active, event.command());
            change(active, event.command());
            if (active.size() > before) {
                places.add(NO_PLACE);
            } else if (active.size() < before) {
                List<Integer> ended = active.isEmpty() ? places : places.subList(oldest, oldest + 1);
                ended.stream().filter(place -> place != NO_PLACE).forEach(place -> ends.set(place, event.time()));
                ended.clear();
            }
        }
        return ends;
    }

    /** Returns the index of the oldest fault that an event ends alone, or the number of faults. */
    private static int indexOfEnded(List<Command> active, Command event) {
        int index = 0;
        while (index < active.size() && !active.get(index).match(ENDS).equals(Optional.of(event))) {
            index++;
        }
        return index;
    }
}
