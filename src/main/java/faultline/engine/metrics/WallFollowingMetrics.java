package faultline.engine.metrics;

import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.FollowerState;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.TickObserver;
import faultline.geometry.Vector2;
import java.util.OptionalDouble;

/**
 * Judges a wall follower from ground truth: how much of the wall it could follow it did follow, and how well it kept
 * the distance. Of other controllers it says nothing.
 */
final class WallFollowingMetrics implements TickObserver {

    /** A straight piece of wall begins and ends this far from a wall's ends, metres. */
    static final double STRAIGHT_MARGIN = 0.5;

    private final boolean isWallFollower;
    private final double distance;
    private final WallReference walls;
    private final Coverage coverage;
    private double sumOfSquares;
    private long errorCount;

    WallFollowingMetrics(SimulationSetup setup) {
        isWallFollower = setup.controller() instanceof ControllerSpec.WallFollowing;
        walls = new WallReference(setup.world());
        distance = setup.controller() instanceof ControllerSpec.WallFollowing wall
                ? wall.distance() + setup.robot().width() / 2
                : 0;
        coverage = new Coverage(walls, distance);
    }

    @Override
    public void observe(Simulation simulation) {
        if (!isWallFollower || simulation.collision().isPresent()) {
            return;
        }
        Vector2 centre = simulation.pose().position();
        ControllerState state = simulation.telemetry().state();
        if (state == FollowerState.FOLLOW || state == FollowerState.ROUND) {
            coverage.visit(centre);
        }
        if (state == FollowerState.FOLLOW) {
            addError(walls.straightWallError(centre, distance, STRAIGHT_MARGIN));
        }
    }

    private void addError(double error) {
        if (!Double.isNaN(error)) {
            sumOfSquares += error * error;
            errorCount++;
        }
    }

    /** The share of the wall that was passed, in [0, 1]; empty where no wall was followed. */
    OptionalDouble coverage() {
        return isWallFollower ? coverage.share() : OptionalDouble.empty();
    }

    /** The distance error on straight walls while following, metres, root mean square; empty where there was none. */
    OptionalDouble distanceRms() {
        return errorCount == 0 ? OptionalDouble.empty() : OptionalDouble.of(StrictMath.sqrt(sumOfSquares / errorCount));
    }
}
