/**
 * Scenario files: XML, checked by a schema and then for sense, read to a {@link faultline.scenario.Scenario} and written back; and running one
 * headless, which is what a user's test calls.
 */
package faultline.scenario;
