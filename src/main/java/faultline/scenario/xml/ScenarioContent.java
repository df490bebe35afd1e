package faultline.scenario.xml;

import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.io.XmlText;

/**
 * The content of a scenario file. It has the components of {@code faultline.scenario.Scenario}, which loads, saves and
 * runs itself: if the reader returned that record, the two packages would depend on each other.
 *
 * @param name a name for people; on one line
 * @param description a description for people, may be empty; on one line
 * @param recorded whether the file is the record of a run
 * @param setup the setup of the run
 * @param expectation the expected result
 */
public record ScenarioContent(
        String name, String description, boolean recorded, SimulationSetup setup, Expectation expectation) {

    /**
     * Creates the content, with the name and the description on one line each.
     *
     * @param name a name for people; on one line
     * @param description a description for people, may be empty; on one line
     * @param recorded whether the file is the record of a run
     * @param setup the setup of the run
     * @param expectation the expected result
     */
    public ScenarioContent {
        name = XmlText.oneLine(name);
        description = XmlText.oneLine(description);
    }
}
