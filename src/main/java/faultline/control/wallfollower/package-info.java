/**
 * The paper's six-state wall follower: one class for each state or group of states, and one estimate of the robot's
 * state. It works in a frame in which the wall is kept on the left. Objects belong to one run and are used by one
 * thread at a time; nothing here knows the true world.
 */
package faultline.control.wallfollower;
