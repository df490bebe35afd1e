package faultline.engine;

import faultline.control.Controller;
import faultline.control.Decision;
import faultline.control.Observation;

/** Calls the controller on the world's own thread. */
final class DirectHost implements ControllerHost {

    private final Controller controller;
    private Observation pending;

    DirectHost(Controller controller) {
        this.controller = controller;
    }

    @Override
    public void submit(Observation observation) {
        pending = observation;
    }

    @Override
    public Decision await() {
        try {
            return controller.decide(pending);
        } catch (RunFailedException broken) {
            throw broken;
        } catch (RuntimeException broken) {
            throw new RunFailedException("the controller broke at tick " + pending.tick() + ": " + broken, broken);
        }
    }

    @Override
    public void close() {
        // Nothing to end.
    }
}
