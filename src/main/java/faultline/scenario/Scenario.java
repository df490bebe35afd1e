package faultline.scenario;

import faultline.engine.Setup;

/**
 * One scenario: what a file holds.
 *
 * @param name for people
 * @param description for people, may be empty
 * @param setup all that determines the run
 * @param expect what the run is expected to give
 */
public record Scenario(String name, String description, Setup setup, Expectation expect) {
}
