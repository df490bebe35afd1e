package faultline.gui;

import static org.junit.jupiter.api.Assertions.fail;

import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/** Waiting for what another thread does, in tests that need no display. */
public final class Await {

    private static final long DEADLINE_SECONDS = 60;

    private Await() {}

    /** Waits until a condition, asked on the event dispatch thread, holds. */
    public static void until(String what, Callable<Boolean> condition) {
        long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(DEADLINE_SECONDS);
        while (!GuiRobot.callOnEdt(condition)) {
            if (System.nanoTime() > deadline) {
                fail("waited " + DEADLINE_SECONDS + " s in vain for " + what);
            }
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(2));
        }
    }
}
