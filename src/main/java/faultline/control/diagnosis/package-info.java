/**
 * Sensor diagnosis: which sensors contradict each other, themselves or the robot's own motion. Works on readings and
 * own commands alone, in a frame in which the wall is kept on the left. Objects belong to one controller and are used
 * by one thread at a time; nothing here knows the true world or decides where to drive.
 */
package faultline.control.diagnosis;
