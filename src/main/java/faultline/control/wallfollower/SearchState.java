package faultline.control.wallfollower;

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
    public void command() {
        estimate.odometer().command(estimate.robot().speed(), 0);
    }

    boolean isWallMet() {
        SensorViews views = estimate.views();
        double radius = estimate.wantedCentreDistance();
        double ahead = estimate.aheadDistance();
        double near = ahead + estimate.stoppingDistance();
        return estimate.isWallAheadWhileSearching()
                || estimate.isFrontTargetWithinTurningCircle()
                || estimate.isLastSeenPointWithin(ahead)
                || views.frontLeft().detectsWithin(near)
                || views.frontRight().detectsWithin(near)
                || views.left().detectsWithin(radius)
                || views.right().detectsWithin(radius);
    }
}
