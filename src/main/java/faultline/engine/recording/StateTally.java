package faultline.engine.recording;

import faultline.control.ControllerState;
import java.util.List;
import java.util.Optional;

/**
 * The durations and visits of a controller's states, and the counts of its transitions. The states of the wall follower
 * and the transitions between them are complete. Of others, those are left out that first appear after
 * {@link #MAX_COUNTS} states, or transitions.
 *
 * @param states the states, in the order of their first appearance
 * @param transitions the transitions, in the order of their first appearance
 */
public record StateTally(List<StateVisits> states, List<TransitionCount> transitions) {

    /** The number of states, and of transitions, after which only those of the wall follower are added. */
    public static final int MAX_COUNTS = 500;

    /** The tally of a run that is not recorded. */
    public static final StateTally EMPTY = new StateTally(List.of(), List.of());

    /**
     * Creates a tally from copies of the lists.
     *
     * @param states the states, in the order of their first appearance
     * @param transitions the transitions, in the order of their first appearance
     */
    public StateTally {
        states = List.copyOf(states);
        transitions = List.copyOf(transitions);
    }

    /**
     * The visits to a state.
     *
     * @param state the state
     * @param ticks the number of ticks in it
     * @param visits the number of visits, including the one at the start
     */
    public record StateVisits(ControllerState state, long ticks, long visits) {}

    /**
     * The count of a transition.
     *
     * @param from the state before
     * @param to the state after
     * @param count the number of times that it was taken
     */
    public record TransitionCount(ControllerState from, ControllerState to, long count) {}

    /**
     * {@return the visits to a state, if there were any}
     *
     * @param state the state
     */
    public Optional<StateVisits> visitsTo(ControllerState state) {
        return states.stream().filter(visits -> visits.state().equals(state)).findFirst();
    }

    /**
     * {@return the number of times that a transition was taken}
     *
     * @param from the state before the transition
     * @param to the state after it
     */
    public long transitionCount(ControllerState from, ControllerState to) {
        return transitions.stream()
                .filter(count -> count.from().equals(from) && count.to().equals(to))
                .mapToLong(TransitionCount::count)
                .sum();
    }
}
