package faultline.gui.document;

import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;

/** The progress of a task, and whether it has been cancelled. Safe for use by any thread. */
public final class TaskProgress {

    private static final double UNKNOWN = -1;

    private volatile double fraction = UNKNOWN;
    private volatile boolean cancelled;
    /** The thread that works on the task, null for none. */
    private Thread worker;

    /** Returns the completed fraction, in [0, 1]; empty if it is unknown. */
    public OptionalDouble fraction() {
        return fraction == UNKNOWN ? OptionalDouble.empty() : OptionalDouble.of(fraction);
    }

    /**
     * Sets the completed fraction, in [0, 1]; throws a {@link CancellationException} if the task has been cancelled.
     */
    public void setFraction(double completed) {
        throwIfCancelled();
        if (!(completed >= 0 && completed <= 1)) {
            throw new IllegalArgumentException("the completed fraction must be in [0, 1]: " + completed);
        }
        fraction = completed;
    }

    /** Does the work of the task on the calling thread, which {@link #cancel} interrupts. */
    <T> T perform(Callable<T> work) throws Exception {
        synchronized (this) {
            throwIfCancelled();
            worker = Thread.currentThread();
        }
        try {
            return work.call();
        } finally {
            endWork();
        }
    }

    private synchronized void endWork() {
        worker = null;
        // A cancellation may have come too late for the work.
        Thread.interrupted();
    }

    /** Cancels the task; work that waits for a controller ends at once. */
    public synchronized void cancel() {
        cancelled = true;
        if (worker != null) {
            worker.interrupt();
        }
    }

    /** Returns whether the task has not been cancelled. */
    public boolean isActive() {
        return !cancelled;
    }

    /** Throws a {@link CancellationException} if the task has been cancelled. */
    public void throwIfCancelled() {
        if (cancelled) {
            throw new CancellationException("the task has been cancelled");
        }
    }
}
