package faultline.app.figures;

import faultline.scenario.Scenario;
import faultline.scenario.ScenarioException;

/** The scenarios that ship with the program, which cannot be bad files. */
final class Shipped {

    private Shipped() {
    }

    static Scenario load(String name) {
        try {
            return Scenario.shipped(name);
        } catch (ScenarioException e) {
            throw new IllegalStateException(e);
        }
    }
}
