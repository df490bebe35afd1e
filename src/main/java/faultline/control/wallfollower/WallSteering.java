package faultline.control.wallfollower;

import faultline.control.GainRule;
import faultline.control.Threshold;

/** FOLLOW and ROUND: steering along a wall, and around its outer corners, by the left sensor. */
final class WallSteering {

    /** A robot that is this much farther away than wanted is on its way to the wall, metres. */
    private static final double DISTANCE_TOLERANCE = 0.02;

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

    /** A slant below this moves the sensor's mounting by less than 0.2 mm, radians. */
    private static final double PARALLEL = StrictMath.toRadians(3);

    private final StateEstimate estimate;
    private double wantedDistance;
    private boolean approaching;
    private GainRule gainRule;
    private final WallTracker tracker = new WallTracker();
    private PdController pdController;

    WallSteering(StateEstimate perception, double wanted, GainRule gainRule) {
        this.estimate = perception;
        configure(wanted, gainRule);
    }

    /** Sets the wanted distance, metres, and the choice of gains. */
    final void configure(double wanted, GainRule newGainRule) {
        approaching |= wantedDistance != 0 && wanted != wantedDistance;
        wantedDistance = wanted;
        gainRule = newGainRule;
    }

    /** Starts along a wall that the robot has been aligned with. */
    void begin() {
        tracker.start(left().detects() ? left().reading() : wantedDistance);
    }

    /** Processes the reading of a decision along a straight wall. */
    void trackWall() {
        tracker.predict(estimate.odometer().deltaDistance(), estimate.odometer().deltaHeading(), 0);
        if (isWallInSight()) {
            // If the robot is slanted to a straight wall by more than half the cone, the reading is at the cone's edge
            // and not the foot.
            double off = Math.max(0, Math.abs(tracker.heading()) - left().halfCone());
            double foot = left().reading() * StrictMath.cos(off);
            if (approaching) {
                approach(foot, off > 0);
            } else {
                tracker.correct(foot, estimate.odometer().deltaDistance(), radius());
            }
        }
    }

    /**
     * Corrects the tracker on the way to a new wanted distance, which is more slanted than any other part of FOLLOW:
     * the sensor's mounting swings away from the wall. Beyond the cone the reading depends on the slant itself, so the
     * heading is that of dead reckoning.
     */
    private void approach(double foot, boolean beyondCone) {
        double swing = estimate.sideMountOffset() * (1 - StrictMath.cos(tracker.heading()));
        double rolled = estimate.odometer().deltaDistance();
        if (beyondCone) {
            tracker.correctDistance(foot - swing, rolled, radius());
        } else {
            tracker.correct(foot - swing, rolled, radius());
        }
        approaching = Math.abs(tracker.heading()) > PARALLEL
                || Math.abs(tracker.distance() - wantedDistance) > DISTANCE_TOLERANCE;
        if (!approaching) {
            // What the front sensor saw on the slanted way was this wall.
            estimate.clearFrontMemory();
        }
    }

    /** Processes the reading of a decision around an outer corner. */
    void trackCorner() {
        tracker.predict(estimate.odometer().deltaDistance(), estimate.odometer().deltaHeading(), 1 / radius());
        if (isWallInSight()) {
            tracker.correct(left().reading(), estimate.odometer().deltaDistance(), radius());
        }
    }

    /** Tracks the corner, because the wall bends away. */
    void switchToCorner() {
        tracker.turnHeading(-bendAngle());
    }

    /** Tracks the wall into which the corner continues. */
    void switchToWall() {
        tracker.turnHeading(bendAngle());
    }

    /** Returns the turn rate along a straight wall, radians per second. */
    double wallTurnRate() {
        return correction();
    }

    /** Returns the turn rate around a corner, radians per second: that of the circle about it, corrected. */
    double cornerTurnRate() {
        return estimate.robot().speed() / radius() + correction();
    }

    private double correction() {
        double speed = estimate.robot().speed();
        double lag = estimate.robot().motor().timeConstant() + estimate.period();
        pdController = new PdController(speed, gainRule.gains(speed, lag));
        return pdController.turnRate(tracker.distance() - wantedDistance, tracker.heading());
    }

    boolean isWallInSight() {
        return left().reading()
                <= Math.max(tracker.distance(), wantedDistance)
                        + estimate.thresholds().get(Threshold.LOST_MARGIN);
    }

    /** Returns whether the robot is no farther from the wall than wanted, within a tolerance. */
    boolean isAtWantedDistance() {
        return tracker.distance() <= wantedDistance + DISTANCE_TOLERANCE;
    }

    boolean bendsAway() {
        double noise = estimate.leftNoise();
        double pair = Math.min(tracker.innovation(), tracker.previousInnovation());
        boolean jumps = tracker.innovation() > noiselessBendThreshold()
                && (tracker.innovation() > NOISE_FACTOR * noise || pair > NOISE_FACTOR_OF_PAIR * noise);
        return jumps && (isSettled() || !tracker.switched()) || isBend(1);
    }

    boolean bendsBack() {
        return isBend(-1) || isSettled() && tracker.drift() < -bendDriftThreshold();
    }

    /**
     * Returns whether the wall bends away, sign 1, or back, sign -1, by the mean of the last innovations; false if they
     * are too noisy for that.
     */
    private boolean isBend(int sign) {
        int count = meanLength();
        double threshold =
                Math.max(noiselessBendThreshold(), MEAN_NOISE_FACTOR * estimate.leftNoise() / Math.sqrt(count));
        return isSettled()
                && threshold <= WallTracker.cornerInnovation(radius())
                && tracker.innovationCount() >= count
                && sign * tracker.meanInnovation(count) > threshold;
    }

    /** Returns the number of innovations whose mean has so little noise that a bend shows, as far as possible. */
    private int meanLength() {
        double ratio = MEAN_NOISE_FACTOR * estimate.leftNoise() / noiselessBendThreshold();
        return (int) Math.max(1, Math.min(WallTracker.MAX_INNOVATIONS, Math.ceil(ratio * ratio)));
    }

    /**
     * Returns whether the tracker's heading can be trusted: after a switch between wall and corner it is a guess, which
     * noisy readings correct only over some distance. Readings without noise make the guess good at once.
     */
    private boolean isSettled() {
        return NOISE_FACTOR * estimate.leftNoise() <= noiselessBendThreshold()
                || tracker.distanceSinceReset() >= SETTLING_MEMORIES * WallTracker.memory(radius());
    }

    /**
     * Returns the drift that counts as a bend back to a wall. A straight wall that is taken for a corner gives the full
     * innovation as long as it lasts, so there is time to average the noise.
     */
    private double bendDriftThreshold() {
        return Math.max(
                noiselessBendThreshold(),
                DRIFT_NOISE_FACTOR
                        * estimate.leftNoise()
                        * WallTracker.driftNoiseShare(estimate.odometer().deltaDistance()));
    }

    private double noiselessBendThreshold() {
        return estimate.thresholds().get(Threshold.BEND_SHARE) * WallTracker.cornerInnovation(radius());
    }

    /**
     * Returns how far the robot has driven around a corner until it is detected: an innovation e needs a distance of
     * sqrt(2 e r) on a circle of radius r.
     */
    private double bendAngle() {
        int count = Math.min(meanLength(), tracker.innovationCount());
        double shown = Math.max(noiselessBendThreshold(), Math.abs(tracker.meanInnovation(count)));
        return Math.sqrt(2 * Math.min(shown, WallTracker.cornerInnovation(radius())) / radius());
    }

    /** Returns the distance from the followed wall, or the corner, to the robot's centre, metres. */
    private double radius() {
        return Math.max(estimate.robot().width() / 2, tracker.distance() + estimate.sideMountOffset());
    }

    private SensorView left() {
        return estimate.views().left();
    }

    /** Returns the P term of the last decision, radians per second; not a number before the first. */
    double proportional() {
        return pdController == null ? Double.NaN : pdController.proportional();
    }

    /** Returns the D term of the last decision, radians per second; not a number before the first. */
    double derivative() {
        return pdController == null ? Double.NaN : pdController.derivative();
    }
}
