package faultline.control.wallfollower;

import faultline.control.FollowerState;
import faultline.control.Threshold;

/** FOLLOW and ROUND: along a wall and around its outer corners, by the left sensor. */
final class WallStates {

    /** A bend too tight for the turn rate slows the robot down, but not below this share of its speed. */
    private static final double MIN_SPEED_SHARE = 0.3;

    private final StateEstimate estimate;
    private final WallSteering steering;
    private final SpinStates spin;
    private double remainingSteerThrough;

    WallStates(StateEstimate estimate, WallSteering steering, SpinStates spin) {
        this.estimate = estimate;
        this.steering = steering;
        this.spin = spin;
    }

    /** Returns FOLLOW: holds the distance to the wall. */
    StateBehaviour follow() {
        return new StateBehaviour() {
            @Override
            public void enter(FollowerState from) {
                if (from == FollowerState.ROUND) {
                    steering.switchToWall();
                } else {
                    steering.begin();
                    remainingSteerThrough =
                            spin.foundSameWall() ? estimate.thresholds().get(Threshold.STEER_THROUGH) : 0;
                }
            }

            @Override
            public void processReading() {
                steering.trackWall();
                remainingSteerThrough -= estimate.odometer().deltaDistance();
            }

            @Override
            public void command() {
                steer(steering.wallTurnRate());
            }
        };
    }

    /** Returns ROUND: circles the corner while it is in sight; otherwise turns tightly until it is seen again. */
    StateBehaviour round() {
        return new StateBehaviour() {
            @Override
            public void enter(FollowerState from) {
                steering.switchToCorner();
            }

            @Override
            public void processReading() {
                steering.trackCorner();
            }

            @Override
            public void command() {
                if (steering.isWallInSight()) {
                    steer(steering.cornerTurnRate());
                } else {
                    estimate.odometer().command(estimate.robot().speed() / 2, estimate.turnRate());
                }
            }
        };
    }

    /**
     * Drives along a bend at the robot's speed; if the bend is too tight for the turn rate, more slowly, so that the
     * bend stays the same.
     */
    private void steer(double rate) {
        double most = estimate.turnRate();
        double share = Math.max(MIN_SPEED_SHARE, Math.min(1, most / Math.abs(rate)));
        estimate.odometer().command(share * estimate.robot().speed(), Math.max(-most, Math.min(most, rate)));
    }

    boolean isWallAhead() {
        return remainingSteerThrough <= 0 && estimate.isWallAheadWhileFollowing(steering.isAtWantedDistance())
                || estimate.isFrontTargetWithinTurningCircle()
                || estimate.views().frontRight().detectsWithin(estimate.guardedRadius());
    }

    boolean isWallEnded() {
        return !steering.isWallInSight() || steering.bendsAway();
    }

    boolean isWallSeenAgain() {
        return steering.isWallInSight() && steering.bendsBack();
    }

    boolean isWallLost() {
        return !steering.isWallInSight();
    }
}
