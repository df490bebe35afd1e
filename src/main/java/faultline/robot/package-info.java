/**
 * The robot's body and drive: its construction, how voltages become wheel speeds, and how wheel speeds change its pose.
 * Immutable values and pure functions on any thread. Nothing here depends on obstacles.
 */
package faultline.robot;
