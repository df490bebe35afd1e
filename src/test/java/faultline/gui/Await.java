package faultline.gui;

import static org.junit.jupiter.api.Assertions.fail;

import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/** Waits for work of other threads in tests without a display. */
public final class Await {

    private static final long DEADLINE_SECONDS = 60;

    private Await() {}

    /** Waits until a condition, evaluated on the event dispatch thread, is true. */
    public static void until(String what, Callable<Boolean> condition) {
        long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(DEADLINE_SECONDS);
        while (!GuiRobot.callOnEdt(condition)) {
            if (System.nanoTime() > deadline) {
                fail("waited " + DEADLINE_SECONDS + " s without success for " + what);
            }
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(2));
        }
    }
}
