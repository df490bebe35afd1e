package faultline.studies;

import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;

/** Loads the scenarios of the studies, which ship with the program and are valid. */
final class StudyScenarios {

    private StudyScenarios() {}

    static Scenario load(String name) {
        try {
            return Scenario.loadShipped(name);
        } catch (ScenarioException e) {
            throw new IllegalStateException(e);
        }
    }
}
