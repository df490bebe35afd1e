package faultline.engine;

import faultline.control.Controller;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.robot.RobotSpec;

/**
 * The hand-over between world and controller, in lock-step: one observation in, one decision out. Used by the world's
 * thread.
 */
interface ControllerHost extends AutoCloseable {

    /**
     * Gives the controller an observation without waiting. Its parts are passed, so that a host on the world's own
     * thread can do without the object.
     *
     * @param tick as in {@link Observation}
     * @param dt as in {@link Observation}
     * @param robot as in {@link Observation}
     * @param readings as in {@link Observation}; not changed until the submission after the next
     */
    void submit(long tick, double dt, RobotSpec robot, double[] readings);

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
