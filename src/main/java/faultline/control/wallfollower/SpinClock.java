package faultline.control.wallfollower;

/** The clock of t_F3, t_F4 and t_p in eq. (4). */
public enum SpinClock {
    /**
     * The angle that the robot has turned by dead reckoning, divided by the constant rate: the acceleration of the spin
     * causes no error. This is the clock of every run.
     */
    TURNED_ANGLE,

    /** The time since the spin began, as in the paper; for studies. */
    ELAPSED_TIME
}
