package faultline.engine.recording;

import faultline.control.ControllerState;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Counts the ticks in each state and the transitions. */
final class StateTallyRecorder {

    private static final class Counter {
        private long ticks;
        private long visits;
    }

    private record TransitionKey(ControllerState from, ControllerState to) {}

    private final Map<ControllerState, Counter> states = new LinkedHashMap<>();
    private final Map<TransitionKey, Counter> transitions = new LinkedHashMap<>();
    private Counter current = new Counter();

    /** Begins in a state, or enters one. */
    void start(ControllerState state) {
        current = states.computeIfAbsent(state, name -> new Counter());
        current.visits++;
    }

    /** Counts a transition, which may lead to the same state. */
    void recordTransition(ControllerState from, ControllerState to) {
        transitions.computeIfAbsent(new TransitionKey(from, to), ends -> new Counter()).visits++;
        start(to);
    }

    /** Counts a tick. */
    void tick() {
        current.ticks++;
    }

    /** Returns the counts so far. */
    StateTally view() {
        List<StateTally.StateVisits> visited = new ArrayList<>();
        states.forEach((state, count) -> visited.add(new StateTally.StateVisits(state, count.ticks, count.visits)));
        List<StateTally.TransitionCount> taken = new ArrayList<>();
        transitions.forEach(
                (ends, count) -> taken.add(new StateTally.TransitionCount(ends.from(), ends.to(), count.visits)));
        return new StateTally(visited, taken);
    }
}
