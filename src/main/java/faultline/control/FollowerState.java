package faultline.control;

/**
 * The six states of the wall follower. Only the caption of the paper's Fig. 8 is known; decision 0002 gives our
 * interpretation.
 */
public enum FollowerState implements ControllerState {
    /** Drives straight ahead until a wall is seen. */
    SEARCH,
    /** Spins right until the left sensor reaches the wall: frame F3. */
    TURN,
    /** Continues the spin until the left sensor leaves the wall: frame F4. */
    MEASURE,
    /** Turns back for t_p = t_D / 2, eq. (4), and waits until the spin has ended. */
    ALIGN,
    /** Follows the wall by PD distance control. */
    FOLLOW,
    /** The wall has ended: drives an arc around the outer corner until a wall is seen again. */
    ROUND
}
