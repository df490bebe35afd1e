package faultline.engine.recording;

import faultline.control.ControllerState;
import java.util.List;
import java.util.Optional;

/**
 * How long a controller has been in each of its states, and how often it took each way between them.
 *
 * @param states in the order of their first appearance
 * @param transitions in the order in which they were first taken
 */
public record StateTally(List<Dwell> states, List<TransitionCount> transitions) {

    /** Of a run that is not recorded. */
    public static final StateTally EMPTY = new StateTally(List.of(), List.of());

    public StateTally {
        states = List.copyOf(states);
        transitions = List.copyOf(transitions);
    }

    /**
     * A state that the controller was in.
     *
     * @param state the state
     * @param ticks in all
     * @param visits how often it came there, the start included
     */
    public record Dwell(ControllerState state, long ticks, long visits) {}

    /**
     * A way from a state to a state that the controller took.
     *
     * @param from the state that it left
     * @param to the state that it came to
     * @param count how often
     */
    public record TransitionCount(ControllerState from, ControllerState to, long count) {}

    /**
     * The stay in a state.
     *
     * @param state the state
     * @return empty where the controller never was there
     */
    public Optional<Dwell> dwell(ControllerState state) {
        return states.stream().filter(stay -> stay.state().equals(state)).findFirst();
    }

    /**
     * How often a way was taken.
     *
     * @param from the state left
     * @param to the state reached
     * @return from 0
     */
    public long transitionCount(ControllerState from, ControllerState to) {
        return transitions.stream()
                .filter(way -> way.from().equals(from) && way.to().equals(to))
                .mapToLong(TransitionCount::count)
                .sum();
    }
}
