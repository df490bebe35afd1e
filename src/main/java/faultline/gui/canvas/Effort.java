package faultline.gui.canvas;

import java.util.function.LongSupplier;

/**
 * How much painting on kept images a frame has time for. What is done is counted, so that the same things are painted in the same frame
 * wherever there is time for them; where the machine is slow or busy, the clock ends it sooner.
 */
final class Effort {

    /** So long may a frame be painted on, nanoseconds. */
    private static final long MOST = 5_000_000;

    private final LongSupplier clock;
    private final long begun;
    private double left = 1;

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

    boolean isSpent() {
        return left <= 0 || clock.getAsLong() - begun > MOST;
    }
}
