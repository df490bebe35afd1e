package faultline.engine.metrics;

import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.FollowerState;
import faultline.control.wallfollower.WallFollower;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.TickObserver;
import faultline.engine.walls.BodyPaths;
import faultline.engine.walls.WallCircuit;
import faultline.engine.walls.WallReference;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.stream.DoubleStream;

/**
 * Judges from ground truth whether a robot carries on after a fault: no contact, and within the time of two laps the
 * robot passes at least 0.80 of its wall within 0.15 m of the wanted path. The time of a lap is its length divided by
 * the robot's speed at the start, plus 10 s for its corners. The clock starts at the last fault of the timeline, or at
 * 0 without one, but not before the first wall follower; if the robot has not met a wall by then, it starts when it
 * does, unless the time of two laps of the longest wall is up: then it does not carry on. A contact counts from the
 * beginning of the run.
 *
 * <p>Its wall is that of the wanted path nearest to it when the clock starts. When the time of this path is up and the
 * robot has not passed enough of its wall, the {@link OtherWalls} count as well, and the robot has the time of two laps
 * of the longest of their paths. Where no passage is narrow, there are no others.
 */
public final class CarryOnMetrics implements TickObserver {

    /** The share of the wall that must be passed. */
    public static final double REQUIRED_SHARE = 0.80;

    /** The time that the robot has, in laps. */
    public static final double ALLOWED_LAPS = 2;

    /** The time that a lap takes in addition to its length divided by the robot's speed, seconds. */
    public static final double CORNER_TIME = 10;

    /** The places of the circuit are this far apart, metres. */
    private static final double PLACE_SPACING = 0.02;

    /** Places nearer to each other than this belong to one path, metres. */
    private static final double JOIN_DISTANCE = 0.04;

    /** A place is passed if the robot's centre comes within this of it, metres. */
    public static final double PASSING_DISTANCE = 0.15;

    /** The least distance between two points of the robot's path that are looked at, metres. */
    private static final double MIN_STEP = 0.02;

    /** The greatest distance between two such points, metres; between points farther apart a place could be missed. */
    private static final double MAX_STEP = 0.05;

    private final WallCircuit circuit;
    private final double speed;
    private final double onset;
    /** Whether the clock starts only in a state of the built-in wall follower. */
    private final boolean needsFollowerState;

    private final PlacePasses passes;
    /** The wall of the path on which the robot was when the clock started. */
    private final PassedWall wall = new PassedWall();

    private int path = -1;
    private double start = Double.NaN;
    private double deadline;
    private double travelled;
    private Vector2 last = Vector2.ZERO;
    /** Where the robot has been since the clock started, until the other walls are looked at. */
    private final List<Vector2> trail = new ArrayList<>();
    /** Null while the robot has time for its first wall. */
    private OtherWalls otherWalls;

    private boolean collided;
    private boolean passedInTime;
    private double time;

    /**
     * Creates metrics of one run.
     *
     * @param setup the setup of the run
     * @param circuit the {@link #circuit} of its world
     */
    public CarryOnMetrics(SimulationSetup setup, WallCircuit circuit) {
        this(circuit, FirstTick.setup(setup));
    }

    private CarryOnMetrics(WallCircuit circuit, SimulationSetup firstTick) {
        this(circuit, firstTick.robot().speed(), onset(firstTick), needsFollowerState(firstTick));
    }

    /**
     * Creates metrics whose clock starts when the robot first follows a wall after a time.
     *
     * @param circuit the circuit of its world
     * @param speed the speed of the robot, metres per second
     * @param onset the time, such as the onset of the last fault, seconds
     */
    CarryOnMetrics(WallCircuit circuit, double speed, double onset) {
        this(circuit, speed, onset, false);
    }

    private CarryOnMetrics(WallCircuit circuit, double speed, double onset, boolean needsFollowerState) {
        this.circuit = circuit;
        this.speed = speed;
        this.onset = onset;
        this.needsFollowerState = needsFollowerState;
        this.passes = new PlacePasses(circuit.size());
        this.deadline = onset + allowedTime(circuit.maxLength());
    }

    /** Returns the time of the last fault or that of the first wall follower, if that is later, seconds. */
    private static double onset(SimulationSetup firstTick) {
        double follower = lateFollower(firstTick)
                .map(timed -> startTime(firstTick, timed))
                .orElse(0.0);
        return Math.max(follower, faultTimes(firstTick).max().orElse(0));
    }

    private double allowedTime(double length) {
        return ALLOWED_LAPS * (length / speed + CORNER_TIME);
    }

    /**
     * {@return the circuit that the robot's centre can drive along the walls; without any path if the robot follows no
     * wall}
     *
     * @param setup the setup of the run
     * @throws WallReference.PathTooLongException if the path is too long
     */
    public static WallCircuit circuit(SimulationSetup setup) {
        SimulationSetup firstTick = FirstTick.setup(setup);
        OptionalDouble distance = wantedDistance(firstTick);
        return distance.isPresent()
                ? circuit(firstTick.world(), distance.getAsDouble(), firstTick.robot())
                : WallCircuit.empty();
    }

    /** Returns the {@link #circuit} of a world at a distance of a robot's centre from the walls, metres. */
    static WallCircuit circuit(WorldSpec world, double distance, RobotSpec robot) {
        List<WallReference.WallSample> places = new WallReference(world).samplesAlongPath(distance, PLACE_SPACING);
        return new WallCircuit(
                places,
                PLACE_SPACING,
                JOIN_DISTANCE,
                PASSING_DISTANCE,
                circuit -> BodyPaths.of(circuit, distance, world, robot.width()));
    }

    /**
     * {@return the distance that a setup's first controller that follows walls keeps between the robot's centre and the
     * wall, metres; empty if none follows walls} A controller that is not part of the program keeps its distance from
     * the side of the platform.
     *
     * @param setup the setup
     */
    public static OptionalDouble wantedDistance(SimulationSetup setup) {
        SimulationSetup firstTick = FirstTick.setup(setup);
        ControllerSpec controller = lateFollower(firstTick)
                .<ControllerSpec>map(timed -> ((Command.ConfigureController) timed.command()).controller())
                .orElse(firstTick.controller());
        return wantedDistance(controller, firstTick.robot());
    }

    /**
     * Returns the first command by which the timeline starts a wall follower; empty if the run begins with one. Of the
     * commands of one tick, the last one counts.
     */
    private static Optional<SimulationSetup.TimedCommand> lateFollower(SimulationSetup firstTick) {
        if (!(firstTick.controller() instanceof ControllerSpec.BuiltIn)
                || firstTick.controller() instanceof ControllerSpec.WallFollowing) {
            return Optional.empty();
        }
        Map<Long, SimulationSetup.TimedCommand> lastOfTicks = new TreeMap<>();
        firstTick.timeline().stream()
                .filter(timed -> timed.command() instanceof Command.ConfigureController)
                .forEach(timed -> lastOfTicks.put(firstTick.tickAt(timed.time()), timed));
        return lastOfTicks.values().stream()
                .filter(timed -> timed.command() instanceof Command.ConfigureController change
                        && change.controller() instanceof ControllerSpec.WallFollowing)
                .findFirst();
    }

    /**
     * Returns whether only the states of the built-in wall follower are at a wall, because the other states are those
     * of controllers that follow none.
     */
    private static boolean needsFollowerState(SimulationSetup setup) {
        return setup.controller() instanceof ControllerSpec.BuiltIn;
    }

    /** Returns whether the robot has met a wall if its controller is in a state. */
    static boolean isAtWall(SimulationSetup setup, ControllerState state) {
        return isAtWall(state, needsFollowerState(setup));
    }

    private static boolean isAtWall(ControllerState state, boolean needsFollowerState) {
        return state != FollowerState.SEARCH
                && (!needsFollowerState || WallFollowingMetrics.FOLLOWER_STATES.contains(state));
    }

    /** Returns the distance that a controller keeps in a robot, metres; empty if it does not follow walls. */
    static OptionalDouble wantedDistance(ControllerSpec controller, RobotSpec robot) {
        if (controller instanceof ControllerSpec.WallFollowing follower) {
            return OptionalDouble.of(WallFollower.wantedCentreDistance(follower, robot));
        }
        OptionalDouble wanted = controller.wantedDistance();
        return wanted.isPresent() ? OptionalDouble.of(wanted.getAsDouble() + robot.width() / 2) : wanted;
    }

    /** Returns when the {@link FaultStarts} of a setup are by the clock of the simulation, seconds. */
    static DoubleStream faultTimes(SimulationSetup setup) {
        return FaultStarts.of(setup).stream().mapToDouble(timed -> startTime(setup, timed));
    }

    /** Returns the time of a command, seconds; the clock may show a little less in its tick, by a rounding error. */
    static double startTime(SimulationSetup setup, SimulationSetup.TimedCommand timed) {
        return Math.min(timed.time(), setup.tickAt(timed.time()) * setup.dt());
    }

    @Override
    public void observe(Simulation simulation) {
        update(
                simulation.time(),
                simulation.pose().position(),
                simulation.telemetry().state(),
                simulation.collision().isPresent());
    }

    /** Records the centre of the robot, metres, the state of its controller and whether it has touched anything. */
    void update(double now, Vector2 centre, ControllerState state, boolean contact) {
        time = now;
        collided = contact;
        if (collided || time < onset || circuit.size() == 0) {
            return;
        }
        if (time > deadline && !passedInTime && otherWalls == null) {
            lookAtOtherWalls();
        }
        if (path >= 0) {
            if (centre.distanceTo(last) >= MIN_STEP) {
                new Segment(last, centre).forEachPoint(MAX_STEP, this::visit);
            }
        } else if (isAtWall(state, needsFollowerState) && time <= deadline) {
            startClock(centre);
        }
    }

    /**
     * Lets the other walls count, with the time of the longest of their paths. A robot that has met no wall has the
     * time of the longest of all paths.
     */
    private void lookAtOtherWalls() {
        if (path < 0) {
            deadline = onset
                    + allowedTime(
                            Math.max(circuit.maxLength(), circuit.bodyPaths().maxLength()));
            return;
        }
        otherWalls = new OtherWalls(circuit, path);
        deadline = start + allowedTime(otherWalls.maxLength());
        for (int i = 1; i < trail.size(); i++) {
            otherWalls.visit(trail.get(i - 1), trail.get(i));
        }
        trail.clear();
        passedInTime = otherWalls.best().share() >= REQUIRED_SHARE;
    }

    private void startClock(Vector2 centre) {
        path = circuit.path(circuit.nearestPlace(centre));
        start = time;
        deadline = time + allowedTime(circuit.length(path));
        for (int i = 0; i < circuit.size(); i++) {
            wall.addLength(circuit.path(i) == path ? circuit.wallLength(i) : 0);
        }
        last = centre;
        trail.add(centre);
        visit(centre);
    }

    private void visit(Vector2 centre) {
        travelled += centre.distanceTo(last);
        if (otherWalls != null) {
            otherWalls.visit(last, centre);
        } else if (!passedInTime) {
            trail.add(centre);
        }
        last = centre;
        circuit.forEachPassed(centre, this::pass);
        if (time <= deadline && share().orElse(0) >= REQUIRED_SHARE) {
            passedInTime = true;
            trail.clear();
        }
    }

    private void pass(int place) {
        if (circuit.path(place) != path) {
            return;
        }
        int pass = passes.record(place, travelled);
        if (pass > 0) {
            wall.pass(circuit.wallLength(place), pass == 1);
        }
    }

    /**
     * {@return whether the verdict is known: there was a contact, or the time is up} Only a later contact could change
     * it.
     */
    public boolean isDecided() {
        return collided || circuit.size() > 0 && time > deadline;
    }

    /** {@return whether the robot carried on: no contact so far, and enough of the wall passed in time} */
    public boolean carriedOn() {
        return passedInTime && !collided;
    }

    /**
     * {@return the share of the wall that was passed since the clock started, in [0, 1]; empty if it did not start} If
     * other walls count, it is that of the wall of which the greatest share was passed.
     */
    public OptionalDouble share() {
        return wall.length() > 0 ? OptionalDouble.of(countedWall().share()) : OptionalDouble.empty();
    }

    /** {@return the number of times that this wall was passed since the clock started, on average over its length} */
    public OptionalDouble laps() {
        return wall.length() > 0 ? OptionalDouble.of(countedWall().laps()) : OptionalDouble.empty();
    }

    /** Returns the first wall, or another one that counts if the robot has passed a greater share of it. */
    private PassedWall countedWall() {
        return otherWalls != null && otherWalls.best().share() > wall.share() ? otherWalls.best() : wall;
    }

    /** {@return when the clock started, seconds; empty if it did not} */
    public OptionalDouble clockStart() {
        return Double.isNaN(start) ? OptionalDouble.empty() : OptionalDouble.of(start);
    }
}
