/**
 * Scenarios for people who write tests: load one, run it without a window, and check the recorded run. Any thread may
 * call it.
 */
package faultline.scenario;
