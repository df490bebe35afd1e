package faultline.gui.document;

import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;

/**
 * Performs tasks that write files on background threads, one after another, in the order in which they were added, so
 * that an older task never overwrites what a newer one has written. Event dispatch thread only.
 */
final class WriteQueue {

    /** Completes when the outcome of the last task is being passed on. */
    private CompletableFuture<Void> last = CompletableFuture.completedFuture(null);

    /**
     * Adds a task, as {@link BackgroundTasks#computeBeforeExit(Callable, Consumer, Consumer)} starts one. The future
     * completes when the outcome of the task is being passed on.
     */
    <T> CompletableFuture<Void> add(Callable<T> task, Consumer<T> onDone, Consumer<Throwable> onFailed) {
        CompletableFuture<Void> previous = last;
        CompletableFuture<Void> end = new CompletableFuture<>();
        last = end;
        BackgroundTasks.computeBeforeExit(
                () -> {
                    previous.join();
                    return task.call();
                },
                result -> {
                    end.complete(null);
                    onDone.accept(result);
                },
                failure -> {
                    end.complete(null);
                    onFailed.accept(failure);
                });
        return end;
    }
}
