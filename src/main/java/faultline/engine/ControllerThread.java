package faultline.engine;

import faultline.io.DecimalText;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * A thread that calls a controller in Java, or its provider, and the limit of the time that each call may take. The
 * executor's queue passes the call and the future returns its result, both with the necessary memory visibility. The
 * thread finds the classes that the thread of the first call finds.
 */
final class ControllerThread implements AutoCloseable {

    /**
     * The time that a call may take, seconds. Time in which other programs prevent this one from running does not
     * count.
     */
    static final double TIMEOUT = 10;

    private static final double NANOS_PER_SECOND = 1e9;
    /**
     * The number of times that the waiting thread wakes within the timeout, or within the time in which a controller
     * that was interrupted must return; each counts the same, however late it is.
     */
    private static final int WAKES = 100;

    private static final long GRACE_MILLIS = 500;

    /**
     * What a call has returned or thrown; the other is null. The executor would ask for the text of what is thrown,
     * which may throw an exception, too. The text may also take any time, which counts as that of the call.
     *
     * @param <T> the type of the result
     * @param result what the call has returned
     * @param failure what the call has thrown
     * @param description what it has thrown as text; null if it has returned
     */
    record CallOutcome<T>(T result, Throwable failure, String description) {

        private static <T> CallOutcome<T> of(Callable<T> call) {
            try {
                return new CallOutcome<>(call.call(), null, null);
            } catch (Throwable failure) {
                return new CallOutcome<>(null, failure, ExceptionText.of(failure));
            }
        }

        private T get() throws ExecutionException {
            if (failure != null) {
                throw new ExecutionException(description, failure);
            }
            return result;
        }
    }

    private final ExecutorService executor;
    private final double timeout;

    /** Creates the thread; the time-out is in seconds. */
    ControllerThread(double timeout) {
        this.timeout = timeout;
        this.executor = Executors.newSingleThreadExecutor(task -> {
            Thread thread = new Thread(task, "faultline-controller");
            thread.setDaemon(true);
            return thread;
        });
    }

    double timeout() {
        return timeout;
    }

    /** Begins a call. */
    <T> Future<CallOutcome<T>> submit(Callable<T> call) {
        return executor.submit(() -> CallOutcome.of(call));
    }

    /**
     * Waits for the result of the last call.
     *
     * @throws ExecutionException with what the call throws, and with a description of it as the message
     * @throws TimeoutException if the call does not return in time
     * @throws InterruptedException if this thread is interrupted
     */
    <T> T await(Future<CallOutcome<T>> result) throws ExecutionException, TimeoutException, InterruptedException {
        for (int i = 1; i < WAKES; i++) {
            try {
                return next(result).get();
            } catch (TimeoutException early) {
                continue;
            }
        }
        return next(result).get();
    }

    private <T> CallOutcome<T> next(Future<CallOutcome<T>> result)
            throws ExecutionException, TimeoutException, InterruptedException {
        return result.get((long) (timeout / WAKES * NANOS_PER_SECOND), TimeUnit.NANOSECONDS);
    }

    /**
     * Interrupts the call, and returns whether the thread has ended, as far as is known. Java cannot stop a thread that
     * ignores this; it is a daemon thread, so the process can still exit.
     */
    boolean end() {
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
        end();
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    /** Says that a method has not returned in time. */
    static String silence(String method, double timeout) {
        return method + " has not returned for " + DecimalText.format(timeout) + " s";
    }

    /**
     * Returns the result of one call on a thread of its own. An interruption from before the call stays and does not
     * end it.
     *
     * @throws ExecutionException with what the call throws, and with a description of it as the message
     * @throws TimeoutException if the call does not return in time
     * @throws RunFailedException if this thread is interrupted during the call. Its message names tick 0, also if the
     *     controller is closed after a run
     */
    static <T> T call(double timeout, Callable<T> call) throws ExecutionException, TimeoutException {
        boolean interrupted = Thread.interrupted();
        try (ControllerThread thread = new ControllerThread(timeout)) {
            return thread.await(thread.submit(call));
        } catch (InterruptedException cancelled) {
            interrupted = true;
            throw new RunFailedException(RunProblem.INTERRUPTED.with(0L), cancelled);
        } finally {
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }
}
