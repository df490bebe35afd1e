package faultline.gui.document;

import java.awt.EventQueue;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.function.Consumer;

/** Runs slow work on background threads and passes the outcome to the event dispatch thread. */
public final class BackgroundTasks {

    /** The threads that keep the program from exiting; used on the event dispatch thread only. */
    private static final Set<Thread> BEFORE_EXIT = new HashSet<>();

    private BackgroundTasks() {}

    /**
     * Starts a computation that ends with the program. Its result, or the exception that it has thrown, is passed to
     * one of the consumers on the event dispatch thread.
     */
    public static <T> void compute(Callable<T> computation, Consumer<T> onDone, Consumer<Throwable> onFailed) {
        start(computation, onDone, onFailed, true);
    }

    /** Starts a computation as {@link #compute} does, and keeps the program from exiting before it has ended. */
    public static <T> void computeBeforeExit(
            Callable<T> computation, Consumer<T> onDone, Consumer<Throwable> onFailed) {
        start(computation, onDone, onFailed, false);
    }

    /** Work without a result. */
    @FunctionalInterface
    public interface Work {
        void run() throws Exception;

        private Callable<Work> withResult() {
            return () -> {
                run();
                return this;
            };
        }
    }

    /**
     * Starts work that ends with the program. On the event dispatch thread, {@code onDone} is called when it has been
     * done, or the exception that it has thrown is passed to {@code onFailed}.
     */
    public static void perform(Work work, Runnable onDone, Consumer<Throwable> onFailed) {
        start(work.withResult(), done -> onDone.run(), onFailed, true);
    }

    /** Starts work as {@link #perform} does, and keeps the program from exiting before it has ended. */
    public static void performBeforeExit(Work work, Runnable onDone, Consumer<Throwable> onFailed) {
        start(work.withResult(), done -> onDone.run(), onFailed, false);
    }

    private static <T> void start(Callable<T> work, Consumer<T> onDone, Consumer<Throwable> onFailed, boolean daemon) {
        assert EventQueue.isDispatchThread();
        Thread thread = new Thread(() -> callAndPassOn(work, onDone, onFailed), "faultline-background");
        thread.setDaemon(daemon);
        if (!daemon) {
            BEFORE_EXIT.removeIf(other -> !other.isAlive());
        }
        thread.start();
        if (!daemon) {
            BEFORE_EXIT.add(thread);
        }
    }

    /**
     * Runs a task on the event dispatch thread when all work that keeps the program from exiting has ended and its
     * results have been passed on. Work that is started with these results is waited for as well.
     */
    public static void runAfterAll(Runnable task) {
        assert EventQueue.isDispatchThread();
        Set<Thread> started = Set.copyOf(BEFORE_EXIT);
        Thread waiting = new Thread(() -> awaitEnd(started, task), "faultline-exit");
        waiting.start();
    }

    private static void awaitEnd(Set<Thread> started, Runnable task) {
        try {
            for (Thread thread : started) {
                thread.join();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return;
        }
        // This comes after the results, because each thread has passed its own to the queue before it ended.
        EventQueue.invokeLater(() -> {
            if (started.containsAll(BEFORE_EXIT)) {
                task.run();
            } else {
                runAfterAll(task);
            }
        });
    }

    private static <T> void callAndPassOn(Callable<T> work, Consumer<T> onDone, Consumer<Throwable> onFailed) {
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
