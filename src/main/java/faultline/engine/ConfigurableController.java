package faultline.engine;

import faultline.control.Controller;
import faultline.control.ControllerSpec;
import faultline.control.Decision;
import faultline.control.Observation;

/**
 * A controller whose settings can be changed during a run. It keeps its state if it can; otherwise a new controller in
 * its initial state takes its place.
 */
final class ConfigurableController implements Controller {

    private ControllerSpec.BuiltIn spec;
    private Controller delegate;
    /** The decision of a controller that uses no observation; null for others. */
    private Decision constant;

    ConfigurableController(ControllerSpec.BuiltIn spec) {
        replace(spec);
    }

    private void replace(ControllerSpec.BuiltIn settings) {
        spec = settings;
        delegate = ControllerFactory.createFixed(settings);
        constant = ControllerFactory.constantDecision(settings).orElse(null);
    }

    @Override
    public Decision decide(Observation observation) {
        return delegate.decide(observation);
    }

    /** Returns the decision on every observation until other settings are taken, or null if decisions differ. */
    Decision constantDecision() {
        return constant;
    }

    @Override
    public void configure(ControllerSpec.BuiltIn settings) {
        if (spec instanceof ControllerSpec.WallFollowing old
                && settings instanceof ControllerSpec.WallFollowing follower
                && old.canContinueWith(follower)) {
            delegate.configure(follower);
            spec = settings;
        } else {
            replace(settings);
        }
    }
}
