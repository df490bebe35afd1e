package faultline.engine;

/**
 * The only place that looks at a clock while a run goes on: how long to wait after a tick, and how fast the run really is. Used by the
 * world thread; it influences when a tick is made and never what it computes.
 */
final class Pacer {

    private static final double NANOS = 1e9;

    /** Debts of more than this are forgiven, so that a machine that was held up does not race afterwards, nanoseconds. */
    private static final long MOST_DEBT = 100_000_000;

    /** The window of {@link #achieved()}, nanoseconds. */
    private static final long WINDOW = 500_000_000;

    private double speed = 1;
    private double dueNanos;
    private long start;
    private double windowSeconds;
    private long windowStart;
    private double achieved;

    Pacer() {
        restart();
    }

    /** Forgets what was due: time begins to run now. */
    void restart() {
        start = System.nanoTime();
        dueNanos = 0;
        windowStart = start;
        windowSeconds = 0;
        achieved = 0;
    }

    void setSpeed(double factor) {
        if (factor != speed) {
            speed = factor;
            restart();
        }
    }

    double speed() {
        return speed;
    }

    /** Counts a tick of some seconds. */
    void ticked(double dt) {
        dueNanos += dt / speed * NANOS;
        windowSeconds += dt;
        long now = System.nanoTime();
        if (now - windowStart >= WINDOW) {
            achieved = windowSeconds / ((now - windowStart) / NANOS);
            windowStart = now;
            windowSeconds = 0;
        }
    }

    /** Times real time over the last window, 0 until the first is over. */
    double achieved() {
        return achieved;
    }

    /** How long to wait until the next tick is due, nanoseconds; not positive where it is. */
    long nanosToWait() {
        long passed = System.nanoTime() - start;
        long wait = (long) dueNanos - passed;
        if (wait < -MOST_DEBT) {
            start = System.nanoTime();
            dueNanos = 0;
        }
        return wait;
    }
}
