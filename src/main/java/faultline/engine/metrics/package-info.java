/**
 * Measures of a run from ground truth: the followed share of the wall, the error of the distance, traces as tables, and
 * headless runs that collect them. Controllers have no access to them. Each object belongs to the thread of its run; a
 * trace has a second thread, which turns its rows into text.
 */
package faultline.engine.metrics;
