package faultline.control.wallfollower;

import faultline.control.FollowerState;
import faultline.robot.Velocity;

/** The behaviour of the follower in one of its states. */
interface StateBehaviour {

    /** Begins the state after another was left. */
    default void enter(FollowerState from) {}

    /** Processes the reading of a decision, before the transitions are checked. */
    default void processReading() {}

    /**
     * Decides on the velocity until the next decision. It is called once in each decision, because it may change what
     * the state remembers, such as the angle that remains to be turned.
     */
    Velocity nextVelocity();
}
