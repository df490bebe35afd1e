package faultline.control.wallfollower;

import faultline.control.FollowerState;

/** What the follower does in one of its states. */
interface StateBehaviour {

    /**
     * Begins the state.
     *
     * @param from the state that was left
     */
    default void enter(FollowerState from) {}

    /** Takes the reading of a decision, before the transitions are tried. */
    default void processReading() {}

    /** Commands the motion of the state. */
    void command();
}
