package faultline.control.wallfollower;

import faultline.robot.Velocity;

/** SEARCH: drives straight ahead until the robot meets a wall. */
final class SearchState implements StateBehaviour {

    private final StateEstimate estimate;

    SearchState(StateEstimate estimate) {
        this.estimate = estimate;
    }

    @Override
    public void processReading() {
        estimate.updateLastSeenPoints();
    }

    @Override
    public Velocity nextVelocity() {
        return new Velocity(estimate.robot().speed(), 0);
    }

    boolean isWallMet() {
        double radius = estimate.wantedCentreDistance();
        double ahead = estimate.aheadDistance();
        double near = ahead + estimate.stoppingDistance();
        return estimate.isWallAheadWhileSearching()
                || estimate.isFrontTargetWithinTurningCircle()
                || estimate.isLastSeenPointWithin(ahead)
                || estimate.frontLeft().detectsWithin(near)
                || estimate.frontRight().detectsWithin(near)
                || estimate.left().detectsWithin(radius)
                || estimate.right().detectsWithin(radius);
    }
}
