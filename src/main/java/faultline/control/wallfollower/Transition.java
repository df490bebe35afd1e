package faultline.control.wallfollower;

import faultline.control.FollowerState;
import java.util.function.Predicate;

/**
 * A transition of the follower's state diagram, with its condition as shown to users and whether it can be taken now.
 */
record Transition(FollowerState from, FollowerState to, String condition, Predicate<WallFollower> guard) {}
