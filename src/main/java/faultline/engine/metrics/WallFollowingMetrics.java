package faultline.engine.metrics;

import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.FollowerState;
import faultline.engine.ControllerFactory;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.TickObserver;
import faultline.geometry.Vector2;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.BiFunction;

/**
 * Measures a wall follower from ground truth: the followed share of the wall, and the error of the distance. Other
 * controllers have no measures.
 */
final class WallFollowingMetrics implements TickObserver {

    /** The distance from the ends of a wall beyond which it counts as straight, metres. */
    static final double STRAIGHT_MARGIN = 0.5;

    /** The maximum number of walls for which the places to pass are found during a run that is shown. */
    private static final int MAX_LIVE_WALLS = 5000;

    /** A list, because a set would call {@code equals} and {@code hashCode} of a record, whose first calls are slow. */
    private static final List<ControllerState> FOLLOWER_STATES =
            ControllerFactory.states(ControllerSpec.WallFollowing.DEFAULT);

    private final boolean isWallFollower;
    /** Whether states that the built-in follower does not have count as following. */
    private final boolean hasOwnStates;

    private final double distance;
    private final WallReference walls;
    private final Coverage coverage;
    /** Null until it is needed, because finding the walls takes a long time in large worlds. */
    private NearestWall nearestWall;

    private final MeanSquare straightError = new MeanSquare();
    private final MeanSquare followError = new MeanSquare();

    /** Creates metrics of one run. */
    WallFollowingMetrics(SimulationSetup setup) {
        this(setup, Coverage::new);
    }

    /** Creates metrics of one run with a coverage for its walls and the wanted distance. */
    WallFollowingMetrics(SimulationSetup setup, BiFunction<WallReference, Double, Coverage> newCoverage) {
        OptionalDouble wanted = CarryOnMetrics.wantedDistance(setup);
        isWallFollower = wanted.isPresent();
        hasOwnStates = !(setup.controller() instanceof ControllerSpec.WallFollowing);
        walls = new WallReference(setup.world());
        distance = wanted.orElse(0);
        coverage = newCoverage.apply(walls, distance);
    }

    @Override
    public void observe(Simulation simulation) {
        if (!isWallFollower || simulation.collision().isPresent()) {
            return;
        }
        walls.share(simulation);
        Vector2 centre = simulation.pose().position();
        ControllerState state = simulation.telemetry().state();
        boolean follows = state == FollowerState.FOLLOW || hasOwnStates && !FOLLOWER_STATES.contains(state);
        if (follows || state == FollowerState.ROUND) {
            coverage.visit(centre);
        }
        if (follows) {
            addError(centre);
        }
    }

    /** Adds how much farther than wanted the nearest wall is, unless it is more than twice as far. */
    private void addError(Vector2 centre) {
        if (nearestWall == null) {
            nearestWall = new NearestWall(walls.walls(), 2 * distance);
        }
        NearestWall.Wall nearest = nearestWall.of(centre, STRAIGHT_MARGIN);
        if (nearest.distance() <= 2 * distance) {
            double error = nearest.distance() - distance;
            followError.add(error);
            if (nearest.straight()) {
                straightError.add(error);
            }
        }
    }

    /** Returns whether there are too many walls to compute the coverage during the run. */
    boolean isLarge() {
        return walls.size() > MAX_LIVE_WALLS;
    }

    /** Returns {@link #coverage} during the run; empty also if there are too many walls. */
    OptionalDouble liveCoverage() {
        return coverage.isEmpty() || isLarge() ? OptionalDouble.empty() : coverage();
    }

    /** Returns the followed share of the wall, in [0, 1]; empty if no wall was followed. */
    OptionalDouble coverage() {
        return isWallFollower ? coverage.share() : OptionalDouble.empty();
    }

    /**
     * Returns the distance error on straight walls while following, metres, root mean square; empty if there were none.
     */
    OptionalDouble distanceRms() {
        return straightError.root();
    }

    /** Returns the distance error on all walls while following, metres, root mean square; empty if there were none. */
    OptionalDouble followRms() {
        return followError.root();
    }

    /** The mean of squared errors. */
    private static final class MeanSquare {
        private double sum;
        private long count;

        void add(double error) {
            sum += error * error;
            count++;
        }

        OptionalDouble root() {
            return count == 0 ? OptionalDouble.empty() : OptionalDouble.of(StrictMath.sqrt(sum / count));
        }
    }
}
