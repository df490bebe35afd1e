package faultline.engine.metrics;

import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.FollowerState;
import faultline.engine.ControllerFactory;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.TickObserver;
import faultline.engine.walls.Coverage;
import faultline.engine.walls.NearestWall;
import faultline.engine.walls.WallReference;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.BiFunction;

/**
 * Measures a wall follower from ground truth: the followed share of the wall, and the error of the distance. If the
 * first controller is none, the measures begin with the first wall follower that a command starts. A controller that is
 * not part of the program is measured from the distance that its specification wants.
 */
final class WallFollowingMetrics implements TickObserver {

    /** The distance from the ends of a wall beyond which it counts as straight, metres. */
    static final double STRAIGHT_MARGIN = 0.5;

    /** The maximum number of walls for which the places to pass are found during a run that is shown. */
    private static final int MAX_LIVE_WALLS = 5000;

    /** The maximum length of the walls then, metres: the coverage takes up to 5 ms whenever it is asked for. */
    private static final double MAX_LIVE_LENGTH = 2000;

    /** A list, because a set would call {@code equals} and {@code hashCode} of a record, whose first calls are slow. */
    static final List<ControllerState> FOLLOWER_STATES = ControllerFactory.states(ControllerSpec.WallFollowing.DEFAULT);

    /** Whether states that the built-in follower does not have count as following. */
    private final boolean hasOwnStates;

    /** The settings and the robot from which the wanted distance is. */
    private ControllerSpec controller;

    private RobotSpec robot;
    /** The wanted distance of the robot's centre from the wall, metres. */
    private double distance;
    /** The first wanted distance, by which the places are found that the robot must pass, metres. */
    private double startDistance;
    /** When the first wall follower began, seconds. */
    private double startTime;

    private final WallReference walls;
    private final BiFunction<WallReference, Double, Coverage> newCoverage;
    /** Null as long as there was no wall follower. */
    private Coverage coverage;
    /** The robot's centre in the last tick. */
    private Vector2 before;
    /** Null until it is needed, because finding the walls takes a long time in large worlds. */
    private NearestWall nearestWall;

    private final MeanSquare straightError = new MeanSquare();
    private final MeanSquare followError = new MeanSquare();

    /** Creates metrics of one run without commands from outside in its first tick. */
    WallFollowingMetrics(SimulationSetup setup) {
        this(FirstTick.setup(setup), Coverage::new);
    }

    /**
     * Creates metrics of one run with a coverage for its walls and the wanted distance.
     *
     * @param setup the {@linkplain FirstTick setup of the first tick}
     * @param newCoverage creates the coverage
     */
    WallFollowingMetrics(SimulationSetup setup, BiFunction<WallReference, Double, Coverage> newCoverage) {
        controller = setup.controller();
        robot = setup.robot();
        hasOwnStates = !(controller instanceof ControllerSpec.BuiltIn);
        before = setup.start().position();
        walls = new WallReference(setup.world());
        this.newCoverage = newCoverage;
        CarryOnMetrics.wantedDistance(controller, robot).ifPresent(wanted -> setDistance(wanted, 0));
    }

    @Override
    public void observe(Simulation simulation) {
        if (simulation.collision().isPresent()) {
            return;
        }
        setController(simulation.controllerSpec(), simulation.robot(), simulation.time());
        if (hasBegun()) {
            walls.share(simulation);
            measure(simulation.pose().position(), simulation.telemetry().state());
        }
    }

    /** Records tick 0 without a contact, given the robot's centre, metres. */
    void measureStart(ControllerSpec spec, RobotSpec platform, Vector2 centre, ControllerState state) {
        setController(spec, platform, 0);
        if (hasBegun()) {
            measure(centre, state);
        }
    }

    @SuppressWarnings("ReferenceEquality") // The same object as long as nothing changes.
    private void setController(ControllerSpec spec, RobotSpec platform, double now) {
        if (spec != controller || platform != robot) {
            controller = spec;
            robot = platform;
            CarryOnMetrics.wantedDistance(controller, robot).ifPresent(wanted -> setDistance(wanted, now));
        }
    }

    private void measure(Vector2 centre, ControllerState state) {
        boolean follows = state == FollowerState.FOLLOW || hasOwnStates && !FOLLOWER_STATES.contains(state);
        if (follows || state == FollowerState.ROUND) {
            new Segment(before, centre)
                    .forEachPoint(Coverage.MAX_STEP, point -> coverage.visit(atStartDistance(point)));
        }
        before = centre;
        if (follows) {
            addError(centre);
        }
    }

    private void setDistance(double wanted, double now) {
        if (!hasBegun()) {
            startTime = now;
            startDistance = wanted;
            distance = wanted;
            coverage = newCoverage.apply(walls, wanted);
        } else if (wanted != distance) {
            distance = wanted;
            nearestWall = null;
        }
    }

    /** Returns the nearest wall, infinitely far away if it is more than twice as far as wanted. */
    private NearestWall.Wall nearestWall(Vector2 centre) {
        if (nearestWall == null) {
            nearestWall = new NearestWall(walls.walls(), 2 * distance);
        }
        return nearestWall.of(centre, STRAIGHT_MARGIN);
    }

    /** Returns whether there is or was a wall follower. */
    boolean hasBegun() {
        return coverage != null;
    }

    /** Returns when the first wall follower began, seconds; 0 as long as there was none. */
    double startTime() {
        return startTime;
    }

    /** Returns the first wanted distance of the robot's centre from the wall, metres; 0 as long as there was none. */
    double startDistance() {
        return startDistance;
    }

    /**
     * Returns the point at which the robot would be at the first wanted distance: moved away from its nearest wall or
     * towards it, by the change of the wanted distance since then.
     */
    Vector2 atStartDistance(Vector2 centre) {
        if (distance == startDistance) {
            return centre;
        }
        NearestWall.Wall nearest = nearestWall(centre);
        if (nearest.distance() == 0 || Double.isInfinite(nearest.distance())) {
            return centre;
        }
        double moved = Math.max(0, nearest.distance() + startDistance - distance);
        return nearest.foot().plus(centre.minus(nearest.foot()).times(moved / nearest.distance()));
    }

    /** Adds how much farther than wanted the nearest wall is, unless it is more than twice as far. */
    private void addError(Vector2 centre) {
        NearestWall.Wall nearest = nearestWall(centre);
        if (nearest.distance() <= 2 * distance) {
            double error = nearest.distance() - distance;
            followError.add(error);
            if (nearest.straight()) {
                straightError.add(error);
            }
        }
    }

    /** Returns whether there are too many walls, or too long ones, to compute the coverage during the run. */
    boolean isLarge() {
        return walls.size() > MAX_LIVE_WALLS || walls.length() > MAX_LIVE_LENGTH;
    }

    /** Returns {@link #coverage} during the run; empty also if the world {@link #isLarge}. */
    OptionalDouble liveCoverage() {
        return !hasBegun() || coverage.isEmpty() || isLarge() ? OptionalDouble.empty() : coverage();
    }

    /** Returns the followed share of the wall, in [0, 1]; empty if no wall was followed, or its path is too long. */
    OptionalDouble coverage() {
        return hasBegun() ? coverage.share() : OptionalDouble.empty();
    }

    /** Returns whether the coverage, when it was last asked for, was not known because of too many places. */
    boolean isPathTooLong() {
        return hasBegun() && coverage.isPathTooLong();
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
