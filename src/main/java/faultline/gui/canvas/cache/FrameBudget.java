package faultline.gui.canvas.cache;

import java.util.function.LongSupplier;

/**
 * The time that a frame has for painting cached images. Work is counted by its cost, so that the same work is done in
 * the same frame on every machine that is fast enough; on a slow or busy machine the clock ends it sooner.
 */
public final class FrameBudget {

    /** The time limit of a frame, nanoseconds. */
    private static final long MAX_NANOS = 5_000_000;

    private static final double FULL = 1;

    private final LongSupplier clock;
    private final long startNanos;
    private double remaining = FULL;

    /** Starts the budget of a frame with a clock, in nanoseconds. */
    public FrameBudget(LongSupplier clock) {
        this.clock = clock;
        this.startNanos = clock.getAsLong();
    }

    /** Spends a fraction of the budget, which is about 5 ms. */
    void spend(double share) {
        remaining -= share;
    }

    /** Returns the remaining fraction; not positive if the budget is spent. */
    double remaining() {
        return remaining;
    }

    /** Returns whether the budget is spent. Each frame does some work, or a slow machine would never finish. */
    public boolean isSpent() {
        return remaining <= 0 || remaining < FULL && clock.getAsLong() - startNanos > MAX_NANOS;
    }
}
