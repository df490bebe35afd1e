package faultline.engine.session;

import java.util.concurrent.locks.LockSupport;
import java.util.function.LongSupplier;

/**
 * Determines how long to wait after a tick, and measures the speed of the run. The clock that it reads determines when
 * a tick is made and never what the tick computes. Used by the thread of the run.
 */
public final class Pacer {

    private static final double NANOS_PER_SECOND = 1e9;

    /**
     * The delay up to which late ticks are caught up, nanoseconds; a longer delay is ignored, so that the run does not
     * catch up at full speed after a pause of the machine.
     */
    private static final long MAX_DEBT = 100_000_000;

    /** The window of {@link #achievedSpeed()}, nanoseconds. */
    private static final long WINDOW = 500_000_000;

    private final LongSupplier clock;
    private double speed = 1;
    private double dueNanos;
    private long start;
    private double windowSeconds;
    private long windowStart;
    private double achievedSpeed;

    /** Creates a pacer at real time, which starts measuring now. */
    public Pacer() {
        this(System::nanoTime);
    }

    /** Creates a pacer with a clock, which returns nanoseconds from any moment on. */
    Pacer(LongSupplier clock) {
        this.clock = clock;
        restart();
    }

    /** Starts measuring from now. */
    void restart() {
        start = clock.getAsLong();
        dueNanos = 0;
        windowStart = start;
        windowSeconds = 0;
        achievedSpeed = 0;
    }

    /**
     * Sets the speed as a multiple of real time.
     *
     * @param factor the speed as a multiple of real time, positive
     */
    public void setSpeed(double factor) {
        if (factor != speed) {
            speed = factor;
            restart();
        }
    }

    double speed() {
        return speed;
    }

    /**
     * Counts a tick of a length in seconds.
     *
     * @param dt the length of the tick, in seconds, positive
     */
    public void tickCompleted(double dt) {
        dueNanos += dt / speed * NANOS_PER_SECOND;
        windowSeconds += dt;
        long now = clock.getAsLong();
        if (now - windowStart >= WINDOW) {
            achievedSpeed = windowSeconds / ((now - windowStart) / NANOS_PER_SECOND);
            windowStart = now;
            windowSeconds = 0;
        }
    }

    /** Returns the speed over the last window as a multiple of real time, 0 until the first window is over. */
    double achievedSpeed() {
        return achievedSpeed;
    }

    /** {@return the time until the next tick is due, nanoseconds; not positive if it is due} */
    public long nanosToWait() {
        long passed = clock.getAsLong() - start;
        long wait = (long) dueNanos - passed;
        if (wait < -MAX_DEBT) {
            start = clock.getAsLong();
            dueNanos = 0;
        }
        return wait;
    }

    /** Waits until the next tick is due or the thread is unparked. */
    void awaitTick() {
        long wait = nanosToWait();
        if (wait > 0) {
            LockSupport.parkNanos(this, wait);
        }
    }
}
