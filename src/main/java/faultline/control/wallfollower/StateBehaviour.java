package faultline.control.wallfollower;

import faultline.control.FollowerState;

/** The behaviour of the follower in one of its states. */
interface StateBehaviour {

    /** Begins the state after another was left. */
    default void enter(FollowerState from) {}

    /** Processes the reading of a decision, before the transitions are checked. */
    default void processReading() {}

    /** Commands the motion of the state. */
    void command();
}
