package faultline.gui.document;

import java.awt.EventQueue;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.function.Consumer;
import javax.swing.SwingWorker;

/** Does slow things off the event dispatch thread, and comes back to it with what they gave. */
final class BackgroundTasks {

    private BackgroundTasks() {}

    /**
     * Does something slow.
     *
     * @param slow what to do
     * @param done told the result, on the event dispatch thread
     * @param failed told the exception in its place, on the event dispatch thread
     */
    static <T> void run(Callable<T> slow, Consumer<T> done, Consumer<Throwable> failed) {
        start(slow, done, failed);
    }

    /** Does the same, and keeps the program from ending before it is done. */
    static <T> void runBeforeExit(Callable<T> slow, Consumer<T> done, Consumer<Throwable> failed) {
        ExitGuard.keepAliveUntilDone(start(slow, done, failed));
    }

    private static <T> Future<T> start(Callable<T> slow, Consumer<T> done, Consumer<Throwable> failed) {
        assert EventQueue.isDispatchThread();
        SwingWorker<T, Void> worker = new SwingWorker<>() {
            @Override
            protected T doInBackground() throws Exception {
                return slow.call();
            }

            @Override
            protected void done() {
                T result;
                try {
                    result = get();
                } catch (ExecutionException broken) {
                    failed.accept(broken.getCause());
                    return;
                } catch (InterruptedException broken) {
                    Thread.currentThread().interrupt();
                    return;
                }
                done.accept(result);
            }
        };
        worker.execute();
        return worker;
    }
}
