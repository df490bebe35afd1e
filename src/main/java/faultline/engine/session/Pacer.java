package faultline.engine.session;

/**
 * The only place that looks at a clock while a run goes on: how long to wait after a tick, and how fast the run really
 * is. Used by the thread of the run; it influences when a tick is made and never what it computes.
 */
public final class Pacer {

    private static final double NANOS_PER_SECOND = 1e9;

    /**
     * Debts of more than this are forgiven, so that a machine that was held up does not race afterwards, nanoseconds.
     */
    private static final long MAX_DEBT = 100_000_000;

    /** The window of {@link #achievedSpeed()}, nanoseconds. */
    private static final long WINDOW = 500_000_000;

    private double speed = 1;
    private double dueNanos;
    private long start;
    private double windowSeconds;
    private long windowStart;
    private double achievedSpeed;

    /** Creates a pacer at real time; time begins to run now. */
    public Pacer() {
        restart();
    }

    /** Forgets what was due: time begins to run now. */
    void restart() {
        start = System.nanoTime();
        dueNanos = 0;
        windowStart = start;
        windowSeconds = 0;
        achievedSpeed = 0;
    }

    /** Sets the speed as a multiple of real time. */
    public void setSpeed(double factor) {
        if (factor != speed) {
            speed = factor;
            restart();
        }
    }

    double speed() {
        return speed;
    }

    /** Counts a tick of some seconds. */
    public void tickCompleted(double dt) {
        dueNanos += dt / speed * NANOS_PER_SECOND;
        windowSeconds += dt;
        long now = System.nanoTime();
        if (now - windowStart >= WINDOW) {
            achievedSpeed = windowSeconds / ((now - windowStart) / NANOS_PER_SECOND);
            windowStart = now;
            windowSeconds = 0;
        }
    }

    /** Times real time over the last window, 0 until the first is over. */
    double achievedSpeed() {
        return achievedSpeed;
    }

    /** How long to wait until the next tick is due, nanoseconds; not positive where it is. */
    public long nanosToWait() {
        long passed = System.nanoTime() - start;
        long wait = (long) dueNanos - passed;
        if (wait < -MAX_DEBT) {
            start = System.nanoTime();
            dueNanos = 0;
        }
        return wait;
    }
}
