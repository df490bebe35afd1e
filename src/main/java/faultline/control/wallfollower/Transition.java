package faultline.control.wallfollower;

import faultline.control.FollowerState;
import java.util.function.Predicate;

/**
 * A transition of the follower's state diagram.
 *
 * @param from the state that it leaves
 * @param to the state that it leads to
 * @param condition its name, as shown to users
 * @param guard whether it can be taken now
 */
record Transition(FollowerState from, FollowerState to, String condition, Predicate<WallFollower> guard) {}
