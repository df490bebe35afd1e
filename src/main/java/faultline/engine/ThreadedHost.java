package faultline.engine;

import faultline.control.Controller;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.robot.RobotSpec;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeoutException;

/**
 * Runs the controller on its own thread. At most one exchange is in progress. If the controller does not answer in
 * time, the run fails; no decision is ever put in its place.
 */
final class ThreadedHost implements ControllerHost {

    private final Controller controller;
    private final ControllerThread thread;
    private Future<ControllerThread.CallOutcome<Decision>> decision;
    private long tick;

    /** Creates the thread; the time-out is in seconds. */
    ThreadedHost(Controller controller, double timeout) {
        this.controller = controller;
        this.thread = new ControllerThread(timeout);
    }

    @Override
    public void submit(long newTick, double dt, RobotSpec robot, double[] readings) {
        tick = newTick;
        Observation observation = new Observation(newTick, dt, robot, readings);
        decision = thread.submit(() -> controller.decide(observation));
    }

    @Override
    public Decision await() {
        try {
            return thread.await(decision);
        } catch (ExecutionException broken) {
            throw RunFailedException.ofController(tick, broken.getCause(), broken::getMessage);
        } catch (TimeoutException silent) {
            throw new RunFailedException(
                    (thread.end() ? RunProblem.NO_ANSWER : RunProblem.NO_END).with(thread.timeout(), tick), silent);
        } catch (InterruptedException ended) {
            Thread.currentThread().interrupt();
            throw new RunFailedException(RunProblem.INTERRUPTED.with(tick), ended);
        }
    }

    @Override
    public void close() {
        thread.close();
    }
}
