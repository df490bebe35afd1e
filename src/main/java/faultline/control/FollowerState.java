package faultline.control;

/**
 * The six states of the wall follower. Only the caption of the paper's Fig. 8 is known; decision 0002 gives our
 * interpretation.
 */
public enum FollowerState implements ControllerState {
    /** Drive on until a wall is seen. */
    SEARCH,
    /** Spin right until the left sensor reaches the wall: frame F3. */
    TURN,
    /** Spin on until the left sensor leaves the wall: frame F4. */
    MEASURE,
    /** Turn back for t_p = t_D / 2, eq. (4), and wait until the spin has ended. */
    ALIGN,
    /** PD distance control along the wall. */
    FOLLOW,
    /** The wall ended: arc around the outer corner until it is seen again. */
    ROUND
}
