package faultline.studies;

import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;

/** The scenarios that ship with the program, which cannot be bad files. */
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
