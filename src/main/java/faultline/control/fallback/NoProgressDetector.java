package faultline.control.fallback;

import faultline.control.diagnosis.DeadReckoning;

/**
 * Detects by dead reckoning that a robot makes no progress: it has not left a square in the time that it takes to drive
 * across it many times. This covers turning on the spot, being enclosed, and small laps, around a pole or around
 * nothing.
 */
final class NoProgressDetector {

    /** The period, as a number of drives across the square. */
    private static final int CROSSINGS = 15;

    /** The number of positions that are stored for that period. */
    private static final int SAMPLES = 60;

    private final double[] xs = new double[SAMPLES];
    private final double[] ys = new double[SAMPLES];
    private int count;
    private double untilSample;

    /** Forgets all positions. */
    void reset() {
        count = 0;
        untilSample = 0;
    }

    /**
     * Adds the position and returns whether the robot makes no progress.
     *
     * @param at the position
     * @param side the side of the square, metres
     * @param speed the speed that it drives at, metres per second
     * @param dt the time since the last call, seconds
     */
    boolean isStuck(DeadReckoning at, double side, double speed, double dt) {
        double interval = CROSSINGS * side / speed / SAMPLES;
        // A long time, such as that before the start of this controller, counts as one interval.
        untilSample = Math.max(-interval, untilSample - dt);
        if (untilSample > 0) {
            return false;
        }
        untilSample += interval;
        xs[count % SAMPLES] = at.x();
        ys[count % SAMPLES] = at.y();
        count++;
        return count >= SAMPLES && extent(xs) < side && extent(ys) < side;
    }

    private static double extent(double[] values) {
        double least = values[0];
        double most = values[0];
        for (double value : values) {
            least = Math.min(least, value);
            most = Math.max(most, value);
        }
        return most - least;
    }
}
