package faultline.engine.session;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

/** Interrupts a tick whose controller does not answer while somebody waits for the run. Any thread may call it. */
final class TickWatch {

    /** The time for which a tick may keep somebody waiting, milliseconds. */
    private static final long PATIENCE = 1000;

    /**
     * The number of checks in this time. Each counts the same, however late it is, so that time in which the program
     * does not run is not counted.
     */
    private static final int CHECKS = 20;

    private final Thread thread;
    private long begun;
    private boolean isTicking;

    /** Creates a watch of the ticks that a thread makes. */
    TickWatch(Thread thread) {
        this.thread = thread;
    }

    /** Executes what makes a tick, on the watched thread. */
    void execute(Runnable tick) {
        begin();
        try {
            tick.run();
        } finally {
            end();
        }
    }

    private synchronized void begin() {
        begun++;
        isTicking = true;
    }

    private synchronized void end() {
        isTicking = false;
        // The thread would no longer wait for the next tick or task after an interrupt.
        Thread.interrupted();
    }

    /** Interrupts a tick that takes a second from now, or from its later start, unless a request is answered before. */
    synchronized void limit(CompletableFuture<Void> answered) {
        checkLater(begun, CHECKS, answered);
    }

    private void checkLater(long watched, int checks, CompletableFuture<Void> answered) {
        CompletableFuture.delayedExecutor(PATIENCE / CHECKS, TimeUnit.MILLISECONDS)
                .execute(() -> check(watched, checks - 1, answered));
    }

    private synchronized void check(long watched, int checksLeft, CompletableFuture<Void> answered) {
        if (answered.isDone() || !thread.isAlive()) {
            return;
        }
        if (!isTicking || begun != watched) {
            limit(answered);
        } else if (checksLeft > 0) {
            checkLater(watched, checksLeft, answered);
        } else {
            thread.interrupt();
        }
    }
}
