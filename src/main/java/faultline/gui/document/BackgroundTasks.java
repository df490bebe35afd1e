package faultline.gui.document;

import java.awt.EventQueue;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;

/** Runs slow work on background threads and passes the outcome to the event dispatch thread. */
public final class BackgroundTasks {

    /** The threads that keep the program from exiting. */
    private static final Set<Thread> BEFORE_EXIT = ConcurrentHashMap.newKeySet();

    private BackgroundTasks() {}

    /**
     * Starts work that ends with the program. Its result, or the exception that it has thrown, is passed to one of the
     * consumers on the event dispatch thread.
     */
    public static <T> void run(Callable<T> work, Consumer<T> onDone, Consumer<Throwable> onFailed) {
        start(work, onDone, onFailed, true);
    }

    /** Starts work as {@link #run} does, and keeps the program from exiting before the work has ended. */
    public static <T> void runBeforeExit(Callable<T> work, Consumer<T> onDone, Consumer<Throwable> onFailed) {
        start(work, onDone, onFailed, false);
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

    /** Starts work without a result, as {@link #run(Callable, Consumer, Consumer)} does. */
    public static void run(Work work, Consumer<Throwable> onFailed) {
        run(work.withResult(), done -> {}, onFailed);
    }

    /** Starts work without a result, and keeps the program from exiting before it has ended. */
    public static void runBeforeExit(Work work, Runnable onDone, Consumer<Throwable> onFailed) {
        runBeforeExit(work.withResult(), done -> onDone.run(), onFailed);
    }

    private static <T> void start(Callable<T> work, Consumer<T> onDone, Consumer<Throwable> onFailed, boolean daemon) {
        assert EventQueue.isDispatchThread();
        Thread thread = new Thread(() -> perform(work, onDone, onFailed), "faultline-background");
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
     * results have been passed on.
     */
    public static void runAfterAll(Runnable task) {
        Thread waiting = new Thread(
                () -> {
                    try {
                        for (Thread thread : BEFORE_EXIT) {
                            thread.join();
                        }
                        EventQueue.invokeLater(() -> runUnlessBusy(task));
                    } catch (InterruptedException e) {
                        Thread.currentThread().interrupt();
                    }
                },
                "faultline-exit");
        waiting.start();
    }

    /** Runs a task, or waits again if the results that have been passed on have started more work. */
    private static void runUnlessBusy(Runnable task) {
        if (BEFORE_EXIT.stream().anyMatch(Thread::isAlive)) {
            runAfterAll(task);
        } else {
            task.run();
        }
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
