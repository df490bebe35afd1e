/**
 * Measures of a run from ground truth: how much of the wall was followed, how far the robot was from the wanted
 * distance, traces as tables, and headless runs that collect them. A controller never sees any of it. Each object
 * belongs to the thread of its run.
 */
package faultline.engine.metrics;
