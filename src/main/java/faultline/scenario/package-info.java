/**
 * Scenarios for the authors of tests: load one, run it without a window, and check the recorded run. Safe on any
 * thread.
 */
package faultline.scenario;
