/**
 * The world that the robot moves in: obstacles that stand or follow way-points, the robot's body among them, what its
 * sensors see, and what can be done to all this from outside (commands). The live {@link faultline.world.World} belongs
 * to one thread; everything that it hands out is an immutable value. Nothing here knows of controllers, clocks or
 * files.
 */
package faultline.world;
