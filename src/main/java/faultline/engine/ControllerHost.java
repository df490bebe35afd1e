package faultline.engine;

import faultline.control.Controller;
import faultline.control.Decision;
import faultline.control.Observation;

/**
 * The hand-over between world and controller, in lock-step: one observation in, one decision out. Used by the world's
 * thread.
 */
interface ControllerHost extends AutoCloseable {

    /**
     * Gives the controller an observation; does not wait.
     *
     * @param observation of this tick
     */
    void submit(Observation observation);

    /**
     * Waits for the decision on the observation submitted last.
     *
     * @return the decision
     * @throws RunFailedException if the controller threw or does not answer
     */
    Decision await();

    @Override
    void close();

    /** Connects a controller as a mode says. */
    static ControllerHost create(Controller controller, ControllerMode mode) {
        return mode == ControllerMode.DIRECT
                ? new DirectHost(controller)
                : new ThreadedHost(controller, ThreadedHost.DECISION_TIMEOUT);
    }
}
