package faultline.control.wallfollower;

import faultline.control.Threshold;

/** Detects bends of the followed wall by the innovations of its tracker: outer corners, and the walls behind them. */
final class BendDetector {

    /**
     * The number of standard deviations of the noise that a bend must exceed, in one reading and in two successive
     * ones. The noise is estimated from a hundred readings only, and may be a third greater; a run has thousands of
     * readings.
     */
    private static final double NOISE_FACTOR = 8;

    private static final double NOISE_FACTOR_OF_PAIR = 4;
    private static final double DRIFT_NOISE_FACTOR = 4;

    /** The number of standard deviations of the noise of a mean that a bend exceeds. */
    private static final double MEAN_NOISE_FACTOR = 5;

    /** The distance after which the tracker has corrected its heading, in units of its memory. */
    private static final double SETTLING_MEMORIES = 4;

    private final StateEstimate estimate;
    private final WallTracker tracker;

    BendDetector(StateEstimate estimate, WallTracker tracker) {
        this.estimate = estimate;
        this.tracker = tracker;
    }

    /** Returns whether the wall bends away, as at an outer corner. */
    boolean isAway() {
        double noise = estimate.leftNoise();
        double pair = Math.min(tracker.innovation(), tracker.previousInnovation());
        boolean jumps = tracker.innovation() > noiselessThreshold()
                && (tracker.innovation() > NOISE_FACTOR * noise || pair > NOISE_FACTOR_OF_PAIR * noise);
        return jumps && (isSettled() || !tracker.switched()) || isBend(1);
    }

    /** Returns whether the corner bends back, into a straight wall. */
    boolean isBack() {
        return isBend(-1) || isSettled() && tracker.drift() < -driftThreshold();
    }

    /**
     * Returns how far the robot has driven around a corner until it is detected, radians: an innovation e needs a
     * distance of sqrt(2 e r) on a circle of radius r.
     */
    double angle() {
        int count = Math.min(meanLength(), tracker.innovationCount());
        double shown = Math.max(noiselessThreshold(), Math.abs(tracker.meanInnovation(count)));
        return Math.sqrt(2 * Math.min(shown, WallTracker.cornerInnovation(radius())) / radius());
    }

    /**
     * Returns whether the wall bends away, sign 1, or back, sign -1, by the mean of the last innovations; false if they
     * are too noisy for that.
     */
    private boolean isBend(int sign) {
        int count = meanLength();
        double threshold = Math.max(noiselessThreshold(), MEAN_NOISE_FACTOR * estimate.leftNoise() / Math.sqrt(count));
        return isSettled()
                && threshold <= WallTracker.cornerInnovation(radius())
                && tracker.innovationCount() >= count
                && sign * tracker.meanInnovation(count) > threshold;
    }

    /**
     * Returns the number of innovations whose mean has, as far as possible, so little noise that a bend can be
     * detected.
     */
    private int meanLength() {
        double ratio = MEAN_NOISE_FACTOR * estimate.leftNoise() / noiselessThreshold();
        return (int) Math.max(1, Math.min(WallTracker.MAX_INNOVATIONS, Math.ceil(ratio * ratio)));
    }

    /**
     * Returns whether the tracker's heading can be trusted: after a switch between wall and corner it is a guess, which
     * noisy readings correct only over some distance. Readings without noise correct it immediately.
     */
    private boolean isSettled() {
        return NOISE_FACTOR * estimate.leftNoise() <= noiselessThreshold()
                || tracker.distanceSinceReset() >= SETTLING_MEMORIES * WallTracker.memory(radius());
    }

    /**
     * Returns the drift that counts as a bend back to a wall. A straight wall that is taken for a corner gives the full
     * innovation as long as it lasts, so there is time to average the noise.
     */
    private double driftThreshold() {
        double rolled = estimate.odometer().deltaDistance();
        return Math.max(
                noiselessThreshold(), DRIFT_NOISE_FACTOR * estimate.leftNoise() * WallTracker.driftNoiseShare(rolled));
    }

    private double noiselessThreshold() {
        return estimate.thresholds().get(Threshold.BEND_SHARE) * WallTracker.cornerInnovation(radius());
    }

    private double radius() {
        return estimate.centreDistance(tracker.distance());
    }
}
