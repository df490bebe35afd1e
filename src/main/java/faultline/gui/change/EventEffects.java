package faultline.gui.change;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.sensor.FaultSequence;
import faultline.sensor.OldestFirst;
import faultline.world.Command;
import faultline.world.Command.CommandCases;
import faultline.world.CommandResult;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/**
 * What events do to their subject: the switch of a sensor, its faults, or the faults of the motors of a side. The state
 * of a subject is represented by the commands that bring it about.
 */
final class EventEffects {

    /** The state after an event; the same object if the event changes nothing. */
    private static final CommandCases<UnaryOperator<FaultSequence<Command>>> CHANGES = new CommandCases<>(
            switchSensor -> state -> state.equals(List.of(switchSensor)) ? state : state(switchSensor),
            other(),
            inject -> state -> state.with(inject),
            clear -> state -> state.without(new Command.InjectFault(clear.sensor(), clear.fault()))
                    .orElse(state),
            clearAll -> EventEffects::cleared,
            inject -> state -> state.with(inject),
            clear -> state -> state.without(new Command.InjectMotorFault(clear.motor(), clear.fault()))
                    .orElse(state),
            clearAll -> EventEffects::cleared,
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

    /** What ends a fault that an event begins; empty for an event that begins none. */
    private static final CommandCases<Optional<Command>> ENDS = new CommandCases<>(
            switchSensor -> Optional.empty(),
            other(),
            inject -> Optional.of(new Command.ClearFault(inject.sensor(), inject.fault())),
            clear -> Optional.empty(),
            clearAll -> Optional.empty(),
            inject -> Optional.of(new Command.ClearMotorFault(inject.motor(), inject.fault())),
            clear -> Optional.empty(),
            clearAll -> Optional.empty(),
            other(),
            other(),
            other(),
            other(),
            other());

    /** What ends all parts of a state; empty for the switch of a sensor, which another state replaces. */
    private static final CommandCases<Optional<Command>> RESETS = new CommandCases<>(
            switchSensor -> Optional.empty(),
            other(),
            inject -> Optional.of(new Command.ClearFaults(inject.sensor())),
            clear -> Optional.of(new Command.ClearFaults(clear.sensor())),
            Optional::of,
            inject -> Optional.of(new Command.ClearMotorFaults(inject.motor())),
            clear -> Optional.of(new Command.ClearMotorFaults(clear.motor())),
            Optional::of,
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

    /**
     * Returns successive events of one subject, the first of which changes something, without those that lead back to a
     * state that it had before them.
     */
    static List<CommandResult> withoutDetours(List<CommandResult> events) {
        if (events.size() == 1) {
            return events;
        }
        List<CommandResult> kept = new ArrayList<>();
        List<List<Command>> states = new ArrayList<>();
        FaultSequence<Command> state = stateBefore(events.get(0));
        states.add(state);
        for (CommandResult event : events) {
            state = after(state, event.command());
            int before = states.indexOf(state);
            if (before < 0) {
                states.add(state);
                kept.add(event);
            } else {
                states.subList(before + 1, states.size()).clear();
                kept.subList(before, kept.size()).clear();
            }
        }
        return kept;
    }

    /** Returns the state that an event brings about alone. */
    static FaultSequence<Command> state(Command event) {
        return FaultSequence.copyOf(List.of(event));
    }

    private static FaultSequence<Command> cleared(FaultSequence<Command> state) {
        return state.isEmpty() ? state : FaultSequence.empty();
    }

    /** Returns the state after an event; the same object if the event changes nothing. */
    static FaultSequence<Command> after(FaultSequence<Command> state, Command event) {
        return event.match(CHANGES).apply(state);
    }

    private static FaultSequence<Command> stateBefore(CommandResult event) {
        FaultSequence<Command> state = FaultSequence.empty();
        for (Command command : event.inverse()) {
            state = after(state, command);
        }
        return state;
    }

    /** Returns what restores a state after an event. The commands are made when they are read. */
    static List<Command> restoration(Command event, FaultSequence<Command> before) {
        return event.match(RESETS)
                .map(clearAll -> CommandResult.restoration(clearAll, before))
                .orElse(before);
    }

    /**
     * Returns the commands that undo an event after other events of its subject. They lead to the state that the others
     * would have led to without it; after others, faults may be in another order.
     */
    static List<Command> undo(CommandResult event, List<Command> others) {
        FaultSequence<Command> without = stateBefore(event);
        FaultSequence<Command> with = after(without, event.command());
        for (Command other : others) {
            without = after(without, other);
            with = after(with, other);
        }
        List<Command> steps = new ArrayList<>();
        TimelineEvents.difference(with, without)
                .forEach(ended -> ended.match(ENDS).ifPresent(steps::add));
        steps.addAll(TimelineEvents.difference(without, with));
        for (Command step : steps) {
            with = after(with, step);
        }
        return others.isEmpty() && !with.equals(without) ? event.inverse() : steps;
    }

    /**
     * Returns when events, in their order, end each of the faults of one subject, seconds; infinity if they do not. The
     * faults are represented by what began them, oldest first.
     */
    static List<Double> ends(List<Command> faults, List<TimedCommand> events) {
        List<Double> ends = new ArrayList<>(Collections.nCopies(faults.size(), Double.POSITIVE_INFINITY));
        // The places of the active faults in the list of ends, by what ends a fault; later faults have none.
        OldestFirst<Command, Integer> active = new OldestFirst<>();
        for (int place = 0; place < ends.size(); place++) {
            active.begin(faults.get(place).match(ENDS).orElseThrow(), place);
        }
        for (TimedCommand event : events) {
            Command command = event.command();
            command.match(ENDS).ifPresent(end -> active.begin(end, NO_PLACE));
            boolean endsAll = command.match(RESETS).equals(Optional.of(command));
            List<Integer> ended =
                    endsAll ? active.endAll() : active.end(command).stream().toList();
            ended.stream().filter(place -> place != NO_PLACE).forEach(place -> ends.set(place, event.time()));
        }
        return ends;
    }
}
