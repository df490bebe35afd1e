/**
 * Scenarios and their files. The author of a test loads one, runs it without a window, and checks the recorded run.
 * {@code ScenarioReader} and the readers of the sections convert a file's elements to values and report all problems
 * together; the writers do the reverse. Safe on any thread.
 */
package faultline.scenario;
