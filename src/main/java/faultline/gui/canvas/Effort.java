package faultline.gui.canvas;

import java.util.function.LongSupplier;

/**
 * How much painting on kept images a frame has time for. What is done is counted, so that the same things are painted in the same frame
 * wherever there is time for them; where the machine is slow or busy, the clock ends it sooner.
 */
final class Effort {

    /** So long may a frame be painted on, nanoseconds. */
    private static final long MOST = 5_000_000;

    private static final double WHOLE = 1;

    private final LongSupplier clock;
    private final long begun;
    private double left = WHOLE;

    /**
     * The effort of a frame that is begun now.
     *
     * @param clock nanoseconds
     */
    Effort(LongSupplier clock) {
        this.clock = clock;
        this.begun = clock.getAsLong();
    }

    /** Counts something that was done, as a share of what a frame has time for: some 5 ms. */
    void spend(double share) {
        left -= share;
    }

    /** What is left, a share; not positive where nothing is. */
    double left() {
        return left;
    }

    /** However late it is, each frame does something, or a slow machine would never come to an end. */
    boolean isSpent() {
        return left <= 0 || left < WHOLE && clock.getAsLong() - begun > MOST;
    }
}
