package faultline.gui.canvas.cache;

import java.util.function.LongSupplier;

/**
 * How much painting on kept images a frame has time for. What is done is counted, so that the same things are painted
 * in the same frame wherever there is time for them; where the machine is slow or busy, the clock ends it sooner.
 */
public final class FrameBudget {

    /** So long may a frame be painted on, nanoseconds. */
    private static final long MAX_NANOS = 5_000_000;

    private static final double FULL = 1;

    private final LongSupplier clock;
    private final long startNanos;
    private double remaining = FULL;

    /**
     * The effort of a frame that is begun now.
     *
     * @param clock nanoseconds
     */
    public FrameBudget(LongSupplier clock) {
        this.clock = clock;
        this.startNanos = clock.getAsLong();
    }

    /** Counts something that was done, as a share of what a frame has time for: some 5 ms. */
    void spend(double share) {
        remaining -= share;
    }

    /** What is left, a share; not positive where nothing is. */
    double remaining() {
        return remaining;
    }

    /** However late it is, each frame does something, or a slow machine would never come to an end. */
    public boolean isSpent() {
        return remaining <= 0 || remaining < FULL && clock.getAsLong() - startNanos > MAX_NANOS;
    }
}
