/**
 * Measures of a run from ground truth: the followed share of the wall, the error of the distance, whether the robot
 * carries on after a fault, what an author expects of a run, and headless runs that collect them. Controllers have no
 * access to them. Each object belongs to the thread of its run.
 */
package faultline.engine.metrics;
