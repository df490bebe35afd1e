package faultline.engine.recording;

import faultline.control.ControllerState;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Counts the ticks in each state and the ways between states. */
final class StateTallyRecorder {

    private static final class Counter {
        private long ticks;
        private long visits;
    }

    private record TransitionKey(ControllerState from, ControllerState to) {}

    private final Map<ControllerState, Counter> states = new LinkedHashMap<>();
    private final Map<TransitionKey, Counter> transitions = new LinkedHashMap<>();
    private Counter current = new Counter();

    /**
     * The controller starts.
     *
     * @param state in this state
     */
    public void start(ControllerState state) {
        current = states.computeIfAbsent(state, name -> new Counter());
        current.visits++;
    }

    /**
     * The controller comes from one state to another, or to the same state again.
     *
     * @param from the state left
     * @param to the state reached
     */
    public void recordTransition(ControllerState from, ControllerState to) {
        transitions.computeIfAbsent(new TransitionKey(from, to), ends -> new Counter()).visits++;
        start(to);
    }

    /** A tick passes. */
    public void tick() {
        current.ticks++;
    }

    /**
     * The counts by now.
     *
     * @return an immutable value
     */
    public StateTally view() {
        List<StateTally.Dwell> stays = new ArrayList<>();
        states.forEach((state, count) -> stays.add(new StateTally.Dwell(state, count.ticks, count.visits)));
        List<StateTally.TransitionCount> taken = new ArrayList<>();
        transitions.forEach(
                (ends, count) -> taken.add(new StateTally.TransitionCount(ends.from(), ends.to(), count.visits)));
        return new StateTally(stays, taken);
    }
}
