package faultline.engine.record;

import java.util.List;
import java.util.Optional;

/**
 * How long a controller has been in each of its states, and how often it took each way between them.
 *
 * @param states in the order of their first appearance
 * @param ways in the order in which they were first taken
 */
public record StateTally(List<Stay> states, List<Way> ways) {

    /** Of a run that is not recorded. */
    public static final StateTally EMPTY = new StateTally(List.of(), List.of());

    public StateTally {
        states = List.copyOf(states);
        ways = List.copyOf(ways);
    }

    /**
     * A state that the controller was in.
     *
     * @param state its name
     * @param ticks in all
     * @param visits how often it came there, the start included
     */
    public record Stay(String state, long ticks, long visits) {
    }

    /**
     * A way from a state to a state that the controller took.
     *
     * @param from the state that it left
     * @param to the state that it came to
     * @param count how often
     */
    public record Way(String from, String to, long count) {
    }

    /**
     * The stay in a state.
     *
     * @param state its name
     * @return empty where the controller never was there
     */
    public Optional<Stay> stay(String state) {
        return states.stream().filter(stay -> stay.state().equals(state)).findFirst();
    }

    /**
     * How often a way was taken.
     *
     * @param from the state left
     * @param to the state reached
     * @return from 0
     */
    public long count(String from, String to) {
        return ways.stream().filter(way -> way.from().equals(from) && way.to().equals(to)).mapToLong(Way::count).sum();
    }
}
