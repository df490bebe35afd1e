package faultline.engine.record;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Counts the ticks in each state and the ways between states. */
public final class StateTallyRecorder {

    private static final class Count {
        private long ticks;
        private long visits;
    }

    private record Ends(String from, String to) {
    }

    private final Map<String, Count> states = new LinkedHashMap<>();
    private final Map<Ends, Count> ways = new LinkedHashMap<>();
    private Count current = new Count();

    /**
     * The controller starts.
     *
     * @param state in this state
     */
    public void start(String state) {
        current = states.computeIfAbsent(state, name -> new Count());
        current.visits++;
    }

    /**
     * The controller comes from one state to another, or the same anew.
     *
     * @param from the state left
     * @param to the state reached
     */
    public void move(String from, String to) {
        ways.computeIfAbsent(new Ends(from, to), ends -> new Count()).visits++;
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
        List<StateTally.Stay> stays = new ArrayList<>();
        states.forEach((state, count) -> stays.add(new StateTally.Stay(state, count.ticks, count.visits)));
        List<StateTally.Way> taken = new ArrayList<>();
        ways.forEach((ends, count) -> taken.add(new StateTally.Way(ends.from(), ends.to(), count.visits)));
        return new StateTally(stays, taken);
    }
}
