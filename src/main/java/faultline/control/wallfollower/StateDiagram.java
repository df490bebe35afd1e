package faultline.control.wallfollower;

import faultline.control.FollowerState;
import faultline.control.Telemetry;
import java.util.List;

/** The wall follower's state diagram: the same table that the follower uses. */
public final class StateDiagram {

    /**
     * All transitions in the order in which they are checked; of those that leave a state, the first whose condition
     * holds is taken.
     */
    public static final List<Arrow> TRANSITIONS = WallFollower.TRANSITIONS.stream()
            .map(transition -> new Arrow(transition.from(), transition.to(), transition.condition()))
            .toList();

    /** The initial state of the follower. */
    public static final FollowerState INITIAL_STATE = WallFollower.INITIAL_STATE;

    private StateDiagram() {}

    /**
     * A transition that can be taken.
     *
     * @param from the state that it leaves
     * @param to the state that it leads to
     * @param condition its name, as in {@link Telemetry#condition()}
     */
    public record Arrow(FollowerState from, FollowerState to, String condition) {}
}
