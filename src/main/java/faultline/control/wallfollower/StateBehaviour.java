package faultline.control.wallfollower;

import faultline.control.FollowerState;
import faultline.robot.Velocity;

/** The behaviour of the follower in one of its states. */
interface StateBehaviour {

    /** Begins the state after another was left. */
    default void enter(FollowerState from) {}

    /** Processes the reading of a decision, before the transitions are checked. */
    default void processReading() {}

    /** Returns the velocity that the state commands until the next decision. */
    Velocity velocity();
}
