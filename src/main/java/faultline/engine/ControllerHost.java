package faultline.engine;

import faultline.control.Controller;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.robot.RobotSpec;

/** Exchanges observations and decisions with the controller in lock-step. Used by the simulation thread. */
interface ControllerHost extends AutoCloseable {

    /**
     * Submits an observation without waiting. Its parts are passed, so that a host on the simulation thread needs no
     * object for them.
     *
     * @param tick as in {@link Observation}
     * @param dt as in {@link Observation}
     * @param robot as in {@link Observation}
     * @param readings as in {@link Observation}; not changed until the submission after the next
     */
    void submit(long tick, double dt, RobotSpec robot, double[] readings);

    /**
     * Waits for the decision on the last observation.
     *
     * @throws RunFailedException if the controller threw an exception or does not answer
     */
    Decision await();

    @Override
    void close();

    /** Creates the host for a mode. */
    static ControllerHost create(Controller controller, ControllerMode mode) {
        return mode == ControllerMode.DIRECT
                ? new DirectHost(controller)
                : new ThreadedHost(controller, ControllerThread.TIMEOUT);
    }
}
