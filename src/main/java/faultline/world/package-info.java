/**
 * The world that the robot moves in: obstacles that stand still or follow waypoints, the robot's body, what its sensors
 * see, and the commands that change all this from outside. The live {@link faultline.world.World} belongs to one
 * thread; its snapshots and the results of commands are immutable values. Nothing here depends on controllers, clocks
 * or files.
 */
package faultline.world;
