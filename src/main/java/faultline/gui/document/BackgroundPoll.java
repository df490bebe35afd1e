package faultline.gui.document;

import java.awt.EventQueue;
import java.util.concurrent.Callable;
import java.util.function.Consumer;

/**
 * Repeats a computation in the background, one at a time. While one waits for a file system that does not answer, no
 * other begins, so that threads do not pile up. Event dispatch thread only.
 */
public final class BackgroundPoll {

    private boolean active;

    /** Starts a computation as {@link BackgroundTasks#compute} does, or nothing if the one before has not ended. */
    public <T> void compute(Callable<T> computation, Consumer<T> onDone, Consumer<Throwable> onFailed) {
        assert EventQueue.isDispatchThread();
        if (!active) {
            BackgroundTasks.compute(computation, result -> end(onDone, result), failure -> end(onFailed, failure));
            // Not before: if no thread can be started, the next call tries again.
            active = true;
        }
    }

    private <R> void end(Consumer<R> consumer, R result) {
        active = false;
        consumer.accept(result);
    }

    /** Returns whether a computation has not ended. */
    boolean isActive() {
        return active;
    }
}
