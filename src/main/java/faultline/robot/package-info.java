/**
 * The robot's body and drive: what it is built of, how voltages become wheel speeds, and how wheel speeds move its
 * pose. Immutable values and pure functions on any thread; nothing here knows of obstacles.
 */
package faultline.robot;
