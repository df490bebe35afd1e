package faultline.gui.change;

import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.gui.change.EventEffects.Subject;
import faultline.sensor.FaultSequence;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The states of what events change, in a run of a setup that executes the commands of its timeline and further events.
 * Needs neither more time nor more memory than in proportion to their number, however many faults a sensor has.
 */
final class EventStates {

    private final SimulationSetup setup;
    /** The commands of the timeline that have not been executed. */
    private final Deque<TimedCommand> planned;

    private final Map<Subject, FaultSequence<Command>> states = new HashMap<>();
    /** The events that have no effect in this run. */
    private final Set<EventIndex.Key> withoutEffect = new HashSet<>();

    /** Takes the states at the start of a run. */
    EventStates(SimulationSetup setup) {
        this.setup = setup;
        planned = setup.timeline().stream()
                .sorted(Comparator.comparingLong(command -> setup.tickAt(command.time())))
                .collect(Collectors.toCollection(ArrayDeque::new));
        setup.robot().sensors().forEach(this::setSwitch);
    }

    private void setSwitch(SensorSpec sensor) {
        Command switched = new Command.SwitchSensor(sensor.id(), sensor.on());
        states.put(EventEffects.subject(switched), EventEffects.state(switched));
    }

    /**
     * Executes an event of another run, unless it only undoes events without an effect in this run. Returns it with
     * what undoes it in this run. Events must be in the order of their ticks.
     */
    ExecutedChange execute(ExecutedChange event) {
        ExecutedChange executed =
                event.undoesOnly(withoutEffect) ? event.withoutEffect() : event.withChange(execute(event.change()));
        if (executed.isEventWithoutEffectNow()) {
            withoutEffect.add(EventIndex.Key.of(executed.executed()));
        }
        return executed;
    }

    /**
     * Executes an event of another run after the commands of the timeline up to its tick. Returns its result with what
     * undoes it in this run. Events must be in the order of their ticks.
     */
    CommandResult execute(CommandResult result) {
        while (!planned.isEmpty() && setup.tickAt(planned.peek().time()) <= result.tick()) {
            executePlanned(planned.remove().command());
        }
        Command event = result.command();
        FaultSequence<Command> before = state(event);
        FaultSequence<Command> after = change(event);
        List<Command> inverse = after == before ? List.of(event) : EventEffects.restoration(event, before);
        return new CommandResult.Executed(result.tick(), event, inverse);
    }

    private void executePlanned(Command command) {
        if (command instanceof Command.ConfigureSensor configure) {
            setSwitch(configure.sensor());
        } else if (TimelineEvents.isEvent(command)) {
            change(command);
        }
    }

    private FaultSequence<Command> state(Command event) {
        return states.computeIfAbsent(EventEffects.subject(event), subject -> FaultSequence.empty());
    }

    private FaultSequence<Command> change(Command event) {
        FaultSequence<Command> after = EventEffects.after(state(event), event);
        states.put(EventEffects.subject(event), after);
        return after;
    }
}
