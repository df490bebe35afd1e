package faultline.gui.document;

import java.awt.EventQueue;
import java.util.concurrent.Callable;
import java.util.function.Consumer;

/** Runs slow work on threads of its own and passes the outcome to the event dispatch thread. */
public final class BackgroundTasks {

    private BackgroundTasks() {}

    /**
     * Starts work that ends with the program. Its result, or what it has thrown instead, is passed to one of the
     * consumers on the event dispatch thread.
     */
    public static <T> void run(Callable<T> work, Consumer<T> onDone, Consumer<Throwable> onFailed) {
        start(work, onDone, onFailed, true);
    }

    /** Starts work as {@link #run} does, and keeps the program from exiting before the work has ended. */
    public static <T> void runBeforeExit(Callable<T> work, Consumer<T> onDone, Consumer<Throwable> onFailed) {
        start(work, onDone, onFailed, false);
    }

    private static <T> void start(Callable<T> work, Consumer<T> onDone, Consumer<Throwable> onFailed, boolean daemon) {
        assert EventQueue.isDispatchThread();
        Thread thread = new Thread(() -> perform(work, onDone, onFailed), "faultline-background");
        thread.setDaemon(daemon);
        thread.start();
    }

    private static <T> void perform(Callable<T> work, Consumer<T> onDone, Consumer<Throwable> onFailed) {
        T result;
        try {
            result = work.call();
        } catch (Exception | Error failure) {
            EventQueue.invokeLater(() -> onFailed.accept(failure));
            return;
        }
        EventQueue.invokeLater(() -> onDone.accept(result));
    }
}
