package faultline.engine;

import faultline.control.Controller;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.robot.RobotSpec;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Runs the controller on its own single-thread executor. The executor's queue passes the observation and the future
 * returns the decision, both with the necessary memory visibility. At most one exchange is in progress.
 */
final class ThreadedHost implements ControllerHost {

    /**
     * The time after which the run fails if the controller has not answered, seconds. No decision is ever put in its
     * place. Time in which other programs prevent this one from running does not count.
     */
    static final double DECISION_TIMEOUT = 10;

    private static final double NANOS_PER_SECOND = 1e9;
    /**
     * The number of times that the waiting thread wakes within the timeout, or within the time in which a controller
     * that was interrupted must return; each counts the same, however late it is.
     */
    private static final int WAKES = 100;

    private static final long GRACE_MILLIS = 500;

    private final Controller controller;
    private final ExecutorService executor;
    private Future<Decision> decision;
    private final double timeout;
    private long tick;

    /** Creates the thread; the time-out is in seconds. */
    ThreadedHost(Controller controller, double timeout) {
        this.controller = controller;
        this.timeout = timeout;
        this.executor = Executors.newSingleThreadExecutor(task -> {
            Thread thread = new Thread(task, "faultline-controller");
            thread.setDaemon(true);
            return thread;
        });
    }

    @Override
    public void submit(long newTick, double dt, RobotSpec robot, double[] readings) {
        tick = newTick;
        Observation observation = new Observation(newTick, dt, robot, readings);
        decision = executor.submit(() -> controller.decide(observation));
    }

    @Override
    public Decision await() {
        try {
            return firstAnswer();
        } catch (ExecutionException broken) {
            throw RunFailedException.ofController(tick, broken.getCause());
        } catch (TimeoutException silent) {
            throw new RunFailedException(
                    (endThread() ? RunProblem.NO_ANSWER : RunProblem.NO_END).with(timeout, tick), silent);
        } catch (InterruptedException ended) {
            Thread.currentThread().interrupt();
            throw new RunFailedException(RunProblem.INTERRUPTED.with(tick), ended);
        }
    }

    private Decision firstAnswer() throws ExecutionException, TimeoutException, InterruptedException {
        for (int i = 1; i < WAKES; i++) {
            try {
                return nextAnswer();
            } catch (TimeoutException early) {
                continue;
            }
        }
        return nextAnswer();
    }

    private Decision nextAnswer() throws ExecutionException, TimeoutException, InterruptedException {
        return decision.get((long) (timeout / WAKES * NANOS_PER_SECOND), TimeUnit.NANOSECONDS);
    }

    /**
     * Interrupts the controller, and returns whether its thread has ended, as far as is known. Java cannot stop a
     * thread that ignores this; it is a daemon thread, so the process can still exit.
     */
    private boolean endThread() {
        executor.shutdownNow();
        try {
            boolean ended = false;
            for (int i = 0; i < WAKES && !ended; i++) {
                ended = executor.awaitTermination(GRACE_MILLIS / WAKES, TimeUnit.MILLISECONDS);
            }
            return ended;
        } catch (InterruptedException ended) {
            Thread.currentThread().interrupt();
            return true;
        }
    }

    /** Waits for the end of the thread, also if interrupted, because the controller may be closed after this. */
    @Override
    public void close() {
        boolean interrupted = Thread.interrupted();
        endThread();
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
