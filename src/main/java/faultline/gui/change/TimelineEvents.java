package faultline.gui.change;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.scenario.Scenario;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The commands that belong to a time of the run: a sensor is switched, or a sensor or motor gets a fault or is
 * repaired. Executed from outside, they are added to the timeline of the scenario.
 */
public final class TimelineEvents {

    private TimelineEvents() {}

    /** Returns whether a command belongs to a time of the run. */
    public static boolean isEvent(Command command) {
        return !command.changesSetup();
    }

    /**
     * Returns what an event changes: the switch or the faults of a sensor, or those of a motor. Equal if it is the
     * same.
     */
    public static Object subject(Command event) {
        return EventEffects.subject(event);
    }

    /**
     * Returns the events among executed commands that changed something, without those of one tick that cancel out,
     * such as a fault that was undone while the run was paused.
     */
    public static List<CommandResult> in(List<CommandResult> executed) {
        List<CommandResult> events = executed.stream()
                .filter(result -> isEvent(result.command()) && !result.isNoOp())
                .toList();
        Map<List<Object>, List<CommandResult>> ofOneTick = events.stream()
                .collect(Collectors.groupingBy(event -> List.of(event.tick(), EventEffects.subject(event.command()))));
        Set<CommandResult> kept = Collections.newSetFromMap(new IdentityHashMap<>());
        ofOneTick.values().forEach(changes -> kept.addAll(EventEffects.withoutDetours(changes)));
        return events.stream().filter(kept::contains).toList();
    }

    /**
     * Returns the commands that undo an event after planned commands. What these have changed remains: a fault that
     * would have ended does not return, and one that has begun continues.
     */
    public static List<Command> undo(CommandResult event, List<Command> planned) {
        EventEffects.Subject subject = EventEffects.subject(event.command());
        List<Command> others = planned.stream()
                .filter(other -> isEvent(other) && EventEffects.subject(other).equals(subject))
                .toList();
        return EventEffects.undo(event, others);
    }

    /**
     * Returns when a timeline ends each of the active faults of one sensor or of the motors of one side, seconds;
     * infinity if it does not. The faults are represented by the commands that add them, oldest first.
     */
    public static List<Double> ends(List<Command> faults, List<TimedCommand> timeline, double now) {
        if (faults.isEmpty()) {
            return List.of();
        }
        Object subject = subject(faults.get(0));
        return EventEffects.ends(
                faults,
                timeline.stream()
                        .filter(planned -> planned.time() > now && isEvent(planned.command()))
                        .filter(planned -> subject(planned.command()).equals(subject))
                        .sorted(Comparator.comparingDouble(TimedCommand::time))
                        .toList());
    }

    /** Returns the elements of a list that another one lacks, each as often as it lacks it; of equal ones, the last. */
    public static <T> List<T> difference(List<T> list, List<T> other) {
        Map<T, Integer> left = new HashMap<>();
        other.forEach(element -> left.merge(element, 1, Integer::sum));
        List<T> difference = new ArrayList<>();
        for (T element : list) {
            int count = left.getOrDefault(element, 0);
            if (count > 0) {
                left.put(element, count - 1);
            } else {
                difference.add(element);
            }
        }
        return difference;
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
