package faultline.gui.document;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.scenario.Scenario;
import faultline.world.Command;
import faultline.world.Command.CommandCases;
import faultline.world.CommandResult;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * The commands that belong to a time of the run: a sensor is switched, or a sensor or motor gets a fault or is
 * repaired. Executed from outside, they are added to the timeline of the scenario.
 */
public final class TimelineEvents {

    private static final CommandCases<Boolean> IS_EVENT =
            CommandCases.ofSetup(event -> true, other(), other(), other(), other(), other(), other());

    private TimelineEvents() {}

    private static <C> Function<C, Boolean> other() {
        return command -> false;
    }

    /** Returns whether a command belongs to a time of the run. */
    public static boolean isEvent(Command command) {
        return command.match(IS_EVENT);
    }

    /** Returns the events among executed commands that changed something, without two of one tick that cancel out. */
    static List<CommandResult> in(List<CommandResult> executed) {
        List<CommandResult> events = new ArrayList<>();
        for (CommandResult result : executed) {
            if (result.isNoOp() || !isEvent(result.command())) {
                continue;
            }
            Optional<CommandResult> cancelled = events.stream()
                    .filter(earlier -> earlier.tick() == result.tick() && cancels(result.command(), earlier.command()))
                    .findFirst();
            if (cancelled.isPresent()) {
                events.remove(cancelled.get());
            } else {
                events.add(result);
            }
        }
        return events;
    }

    private static boolean cancels(Command command, Command earlier) {
        if (command instanceof Command.SwitchSensor now && earlier instanceof Command.SwitchSensor before) {
            return now.sensor().equals(before.sensor()) && now.on() != before.on();
        }
        return earlier instanceof Command.InjectFault inject
                        && command.equals(new Command.ClearFault(inject.sensor(), inject.fault()))
                || earlier instanceof Command.InjectMotorFault broken
                        && command.equals(new Command.ClearMotorFault(broken.motor(), broken.fault()));
    }

    /** Returns a scenario whose timeline lacks some events; of equal ones, it lacks the last. */
    public static Scenario without(Scenario scenario, List<TimedCommand> events) {
        List<TimedCommand> timeline = new ArrayList<>(scenario.setup().timeline());
        for (TimedCommand event : events) {
            int index = timeline.lastIndexOf(event);
            if (index >= 0) {
                timeline.remove(index);
            }
        }
        return scenario.withSetup(scenario.setup().withTimeline(timeline));
    }

    /** Returns a scenario with more events at the end of its timeline, except for those of sensors that it lacks. */
    public static Scenario with(Scenario scenario, List<TimedCommand> events) {
        List<TimedCommand> timeline = new ArrayList<>(scenario.setup().timeline());
        events.stream()
                .filter(event -> SensorReference.isOn(scenario.setup().robot(), event.command()))
                .forEach(timeline::add);
        return scenario.withSetup(scenario.setup().withTimeline(timeline));
    }
}
