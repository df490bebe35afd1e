package faultline.control.wallfollower;

import faultline.control.FollowerState;
import java.util.function.Predicate;

/**
 * One arrow of the follower's state diagram.
 *
 * @param from the state that it leaves
 * @param to the state that it leads to
 * @param condition its name, for people
 * @param guard whether it is taken now
 */
record Transition(FollowerState from, FollowerState to, String condition, Predicate<WallFollower> guard) {}
