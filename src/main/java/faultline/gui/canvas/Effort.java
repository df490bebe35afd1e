package faultline.gui.canvas;

/**
 * How much painting on kept images a frame has time for. It is counted and not measured, so that the same things are always painted in the
 * same frame.
 */
final class Effort {

    private double left = 1;

    /** Counts something that was done, as a share of what a frame has time for: some 5 ms. */
    void spend(double share) {
        left -= share;
    }

    /** What is left, a share; not positive where nothing is. */
    double left() {
        return left;
    }

    boolean isSpent() {
        return left <= 0;
    }
}
