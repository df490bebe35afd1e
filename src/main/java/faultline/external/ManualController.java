package faultline.external;

import faultline.control.Controller;
import faultline.control.Decision;
import faultline.control.Observation;

/** Holds the decision that was last given from outside, and keeps the newest observation to be asked for. */
final class ManualController implements Controller {

    private Decision decision;

    ManualController(Decision first) {
        decision = first;
    }

    void set(Decision next) {
        decision = next;
    }

    @Override
    public Decision decide(Observation observation) {
        return decision;
    }
}
