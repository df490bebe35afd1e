package faultline.control.wallfollower;

import faultline.control.FollowerState;
import faultline.control.GainRule;
import faultline.control.PdGains;
import faultline.control.Threshold;
import faultline.robot.Velocity;

/**
 * FOLLOW and ROUND: along a wall and around its outer corners, by the left sensor. The PD distance controller steers:
 * omega = kp e + kd e', where e is the distance error, positive if the wall is too far; see {@link PdGains}.
 */
final class WallStates {

    /** The distance error above which the robot is still approaching the wall, metres. */
    private static final double DISTANCE_TOLERANCE = 0.02;

    /** A slant below this moves the sensor's mounting by less than 0.2 mm, radians. */
    private static final double PARALLEL = StrictMath.toRadians(3);

    private final StateEstimate estimate;
    private final SpinStates spin;
    private final WallTracker tracker = new WallTracker();
    private final BendDetector bends;
    private double wantedDistance;
    private GainRule gainRule;
    private boolean approaching;
    private double remainingSteerThrough;
    private double proportional = Double.NaN;
    private double derivative = Double.NaN;

    WallStates(StateEstimate estimate, SpinStates spin, double wanted, GainRule gainRule) {
        this.estimate = estimate;
        this.spin = spin;
        this.bends = new BendDetector(estimate, tracker);
        configure(wanted, gainRule);
    }

    /** Sets the wanted distance, metres, and the choice of gains. */
    final void configure(double wanted, GainRule newGainRule) {
        approaching |= wantedDistance != 0 && wanted != wantedDistance;
        wantedDistance = wanted;
        gainRule = newGainRule;
    }

    /** Returns the behaviour in FOLLOW. */
    StateBehaviour follow() {
        return new FollowState();
    }

    /** Returns the behaviour in ROUND. */
    StateBehaviour round() {
        return new RoundState();
    }

    /** Starts along a wall that the robot has been aligned with. */
    void begin() {
        tracker.start(left().detects() ? left().reading() : wantedDistance);
        estimate.forgetWallOfSpin();
    }

    /** Tracks the corner, because the wall bends away. */
    void switchToCorner() {
        tracker.turnHeading(-bends.angle());
    }

    /** Processes the reading of a decision along a straight wall. */
    void trackWall() {
        tracker.predict(rolled(), estimate.odometer().deltaHeading(), 0);
        if (isWallInSight()) {
            // If the robot is slanted to a straight wall by more than half the cone, the reading is at the cone's edge
            // and not the foot.
            double off = Math.max(0, Math.abs(tracker.heading()) - left().halfCone());
            double foot = left().reading() * StrictMath.cos(off);
            if (approaching) {
                approach(foot, off > 0);
            } else {
                tracker.correct(foot, rolled(), radius());
            }
        }
    }

    /**
     * Corrects the tracker during the approach to a new wanted distance, which is more slanted than any other part of
     * FOLLOW: the sensor's mounting swings away from the wall. Beyond the cone the reading depends on the slant itself,
     * so the heading is that of dead reckoning.
     */
    private void approach(double foot, boolean beyondCone) {
        double swing = estimate.sideMountOffset() * (1 - StrictMath.cos(tracker.heading()));
        if (beyondCone) {
            tracker.correctDistance(foot - swing, rolled(), radius());
        } else {
            tracker.correct(foot - swing, rolled(), radius());
        }
        approaching = Math.abs(tracker.heading()) > PARALLEL
                || Math.abs(tracker.distance() - wantedDistance) > DISTANCE_TOLERANCE;
        if (!approaching) {
            // During the slanted approach, the front sensor saw this wall.
            estimate.clearFrontMemory();
        }
    }

    /** Processes the reading of a decision around an outer corner. */
    void trackCorner() {
        tracker.predict(rolled(), estimate.odometer().deltaHeading(), 1 / radius());
        if (isWallInSight()) {
            tracker.correct(left().reading(), rolled(), radius());
        }
    }

    /**
     * Computes the turn rate of the PD controller, radians per second, which is the whole turn rate along a straight
     * wall, and keeps its terms for {@link #proportional()} and {@link #derivative()}.
     */
    double correctingTurnRate() {
        double speed = estimate.robot().speed();
        double lag = estimate.robot().motor().timeConstant() + estimate.period();
        PdGains gains = gainRule.gains(speed, lag);
        proportional = gains.proportionalTerm(tracker.distance() - wantedDistance);
        derivative = gains.derivativeTerm(-speed * StrictMath.sin(tracker.heading()));
        return proportional + derivative;
    }

    /** Forgets the terms of the last decision; one that does not correct the distance has none. */
    void clearTerms() {
        proportional = Double.NaN;
        derivative = Double.NaN;
    }

    /** Returns the turn rate around a corner, radians per second: that of the circle about it, corrected. */
    double cornerTurnRate() {
        return estimate.robot().speed() / radius() + correctingTurnRate();
    }

    private Velocity onCurve(double rate) {
        return WallFollower.onCurve(estimate.robot().speed(), rate, estimate.turnRate());
    }

    boolean isWallAhead() {
        boolean atWantedDistance = tracker.distance() <= wantedDistance + DISTANCE_TOLERANCE;
        return remainingSteerThrough <= 0 && estimate.isWallAheadWhileFollowing(atWantedDistance)
                || estimate.isFrontTargetWithinTurningCircle()
                || estimate.frontRight().detectsWithin(estimate.guardedRadius())
                || estimate.isNearSideObjectWithinTurningCircle()
                || !isWallInSight() && estimate.isLostWallWithinTurningCircle();
    }

    boolean isWallInSight() {
        return left().reading()
                <= Math.max(tracker.distance(), wantedDistance)
                        + estimate.thresholds().get(Threshold.LOST_MARGIN);
    }

    boolean isWallEnded() {
        return !isWallInSight() || bends.isAway();
    }

    boolean isWallSeenAgain() {
        return isWallInSight() && bends.isBack();
    }

    /** Returns the distance rolled since the last decision, metres. */
    private double rolled() {
        return estimate.odometer().deltaDistance();
    }

    private double radius() {
        return estimate.centreDistance(tracker.distance());
    }

    private SensorView left() {
        return estimate.left();
    }

    /** Returns the P term of the last decision, radians per second; not a number if it has none. */
    double proportional() {
        return proportional;
    }

    /** Returns the D term of the last decision, radians per second; not a number if it has none. */
    double derivative() {
        return derivative;
    }

    /** FOLLOW: holds the distance to the wall. */
    private final class FollowState implements StateBehaviour {
        @Override
        public void enter(FollowerState from) {
            if (from == FollowerState.ROUND) {
                // The corner continues into this wall.
                tracker.turnHeading(bends.angle());
            } else {
                begin();
                remainingSteerThrough =
                        spin.foundSameWall() ? estimate.thresholds().get(Threshold.STEER_THROUGH) : 0;
            }
        }

        @Override
        public void processReading() {
            trackWall();
            remainingSteerThrough -= estimate.odometer().deltaDistance();
        }

        @Override
        public Velocity nextVelocity() {
            return onCurve(correctingTurnRate());
        }
    }

    /** ROUND: circles the corner while it is seen; otherwise turns tightly until it is seen again. */
    private final class RoundState implements StateBehaviour {
        @Override
        public void enter(FollowerState from) {
            switchToCorner();
        }

        @Override
        public void processReading() {
            trackCorner();
        }

        @Override
        public Velocity nextVelocity() {
            return isWallInSight()
                    ? onCurve(cornerTurnRate())
                    : new Velocity(estimate.robot().speed() / 2, estimate.turnRate());
        }
    }
}
