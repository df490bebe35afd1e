package faultline.engine.recording;

import faultline.control.ControllerState;
import faultline.control.FollowerState;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Counts the ticks in each state and the transitions. A controller may name a new state in every tick, so the number of
 * those that are counted is limited.
 */
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
        current = counter(states, state, state instanceof FollowerState);
        current.visits++;
    }

    /** Counts a transition, which may lead to the same state. */
    void recordTransition(ControllerState from, ControllerState to) {
        boolean ofFollower = from instanceof FollowerState && to instanceof FollowerState;
        counter(transitions, new TransitionKey(from, to), ofFollower).visits++;
        start(to);
    }

    /** Returns the counter of a key: a new one, which is kept if the key is always counted or there is room. */
    private static <K> Counter counter(Map<K, Counter> counters, K key, boolean always) {
        Counter known = counters.get(key);
        if (known != null) {
            return known;
        }
        Counter added = new Counter();
        if (always || counters.size() < StateTally.MAX_COUNTS) {
            counters.put(key, added);
        }
        return added;
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
