/**
 * Sensor diagnosis: which sensors contradict each other, themselves or the robot's own motion. It uses only readings
 * and the controller's own commands, in a frame in which the wall is on the left. Objects belong to one controller and
 * are used by one thread at a time; nothing here knows the true world or decides where to drive.
 */
package faultline.control.diagnosis;
