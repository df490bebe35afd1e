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

    ConfigurableController(ControllerSpec.BuiltIn spec) {
        this.spec = spec;
        delegate = ControllerFactory.createFixed(spec);
    }

    @Override
    public Decision decide(Observation observation) {
        return delegate.decide(observation);
    }

    @Override
    public void configure(ControllerSpec.BuiltIn settings) {
        if (spec instanceof ControllerSpec.WallFollowing old
                && settings instanceof ControllerSpec.WallFollowing follower
                && old.canContinueWith(follower)) {
            delegate.configure(follower);
        } else {
            delegate = ControllerFactory.createFixed(settings);
        }
        spec = settings;
    }
}
