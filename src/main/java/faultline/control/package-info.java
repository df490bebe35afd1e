/**
 * Controllers: an observation in, a decision out. They know the robot's build, its sensors' reported readings and their
 * own past commands, and nothing of the true world. A controller is used by one thread at a time.
 */
package faultline.control;
