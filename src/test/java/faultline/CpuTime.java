package faultline;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/**
 * The processor time of the current thread from a moment on, which other programs on the machine do not increase as
 * they increase the time by the clock.
 */
public final class CpuTime {

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final long begun = THREADS.getCurrentThreadCpuTime();

    private CpuTime() {}

    /** Starts to measure. */
    public static CpuTime start() {
        return new CpuTime();
    }

    /** Fails if the thread has needed too much time, in seconds. */
    public void assertBelow(double max) {
        double seconds = (THREADS.getCurrentThreadCpuTime() - begun) / 1e9;
        assertTrue(seconds < max, seconds + " s");
    }
}
