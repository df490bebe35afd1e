package faultline.control.fallback;

import faultline.control.ControllerSpec;
import faultline.control.FollowerState;
import faultline.control.Telemetry.WallControl;
import faultline.control.diagnosis.DeadReckoning;
import faultline.control.diagnosis.SensorDiagnosis;
import faultline.control.wallfollower.WallFollower;
import faultline.geometry.Angles;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;

/**
 * Follows a wall on the left with the local map. It drives only where trusted sensors have recently seen free space;
 * otherwise it turns until one of them sees the path.
 */
public final class MapFollower {

    /** The time for which an observation counts, on the motion clock: one metre, ten radians or 100 seconds. */
    private static final int MEMORY = 1000;

    /** The time between two plans, seconds; eight sensors are inspected as often at the full rate. */
    private static final double PLAN_INTERVAL = 0.08;

    /** The time between two plans while the robot scans, seconds: a scan ends as soon as enough has been seen. */
    private static final double SCAN_PLAN_INTERVAL = 0.04;

    /** The distance that it looks ahead along the wall, metres. */
    private static final double LOOK_AHEAD = 0.2;

    /** The distance by which it leaves a wall that is too near while it drives as far as it looks ahead, metres. */
    private static final double STEP_AWAY = 0.1;

    /**
     * A robot that touches a wall with its turning circle gets at least this much farther away within the distance that
     * it looks ahead, metres: somewhat less than that distance, because surfaces are enlarged to whole cells.
     */
    private static final double REACHED_WITHOUT_STEPS = 0.18;

    /** The amount by which the distance may become less while the robot keeps it: one cell of the map, metres. */
    private static final double MAY_COME_NEARER = 0.025;

    /** Ground within this of the turning circle is taken to be free, because no sensor can see it, metres. */
    private static final double UNSEEN_NEAR_BODY = 0.05;

    /**
     * The amount by which the planned distance to the wall is less than the wanted one, because surfaces are enlarged
     * to whole cells, metres.
     */
    private static final double COARSENESS = 0.04;

    /**
     * The margin that the planned distance leaves around the circle in which the robot turns, and a larger planned
     * distance around that circle on the side that does not face the wall, metres.
     */
    private static final double TURNING_MARGIN = 0.07;

    /** The margin does not make the planned distance larger than this, because passages may be narrow, metres. */
    private static final double MAX_WITH_MARGIN = 0.3;

    /** The amount by which the wall may be farther away than wanted, metres; surfaces beyond it are not the wall. */
    private static final double WALL_WITHIN = 0.35;

    /** The amount by which a wall that is found in a search may be farther away than planned, metres. */
    private static final double FOUND_WITHIN = 0.1;

    /** The margin of a square that contains a lap around a pole at the wanted distance, metres. */
    private static final double LAP_MARGIN = 0.4;

    private static final double QUARTER = StrictMath.PI / 2;

    /** A direction that is this far clockwise from the wall leads back, radians; decision 0033. */
    private static final double TURNED_BACK = StrictMath.toRadians(240);

    private final SensorDiagnosis diagnosis;
    /** The live pose of the robot. */
    private final DeadReckoning at;

    private ControllerSpec.WallFollowing spec;
    private final LocalMap map = new LocalMap();
    private final FreeDirectionFinder directionFinder = new FreeDirectionFinder(map);
    private final WallBearing wall = new WallBearing(map);
    private final KnownPath path;
    private final Retreat retreat = new Retreat();
    private final NoProgressDetector progress = new NoProgressDetector();
    /** Null before the first decision. */
    private RobotSpec robot;
    /** The distance from the centre to the sensor that faces the wall, which reads the wanted distance, metres. */
    private double sideMountOffset;
    /** The wanted distance from the centre to the wall, metres. */
    private double wantedCentreDistance;

    private DriveDirection driveDirection = DriveDirection.FORWARDS;
    /** The direction of the path, radians in the frame of the map. */
    private double direction;

    private double untilPlan;
    private boolean stuck;
    private FollowerState state = FollowerState.FOLLOW;
    private WallControl wallControl = WallControl.NONE;
    private double v;
    private double omega;

    /**
     * Creates a follower.
     *
     * @param diagnosis the diagnosis of the sensors
     * @param spec the settings, of which it uses the side of the wall and the wanted distance
     */
    public MapFollower(SensorDiagnosis diagnosis, ControllerSpec.WallFollowing spec) {
        this.diagnosis = diagnosis;
        this.at = diagnosis.reckoning();
        this.path = new KnownPath(diagnosis, directionFinder);
        this.spec = spec;
    }

    /**
     * Sets the wanted distance from the sensor that faces the wall to the wall, or from the side of the platform if no
     * sensor does.
     *
     * @param settings the settings
     * @throws IllegalArgumentException if a running follower cannot continue with them
     */
    public void configure(ControllerSpec.WallFollowing settings) {
        spec = spec.changedTo(settings);
        if (robot != null) {
            updateDistances();
        }
    }

    private void updateDistances() {
        sideMountOffset = WallFollower.sideMountOffset(spec.side(), robot);
        wantedCentreDistance = WallFollower.wantedCentreDistance(spec, robot);
    }

    /**
     * Begins to drive, with the wall on the left.
     *
     * @param atWall whether the robot is already at the wall
     */
    public void begin(boolean atWall) {
        driveDirection = DriveDirection.of(diagnosis);
        direction = atWall ? at.heading() : driveDirection.leading(at.heading());
        directionFinder.begin(direction);
        wall.begin(direction + QUARTER, atWall);
        untilPlan = 0;
        path.endScan();
        retreat.end();
        state = atWall ? FollowerState.FOLLOW : FollowerState.SEARCH;
        stuck = false;
        progress.reset();
    }

    /**
     * Decides on the velocity.
     *
     * @param now the robot as the controller believes it to be
     * @param dt the time since the last decision, seconds
     */
    @SuppressWarnings("ReferenceEquality") // The same object as long as nothing changes.
    public void decide(RobotSpec now, double dt) {
        if (now != robot) {
            robot = now;
            updateDistances();
        }
        double lap = 2 * (spec.distance() + robot.width()) + LAP_MARGIN;
        stuck |= progress.isStuck(at, lap, robot.speed(), dt);
        untilPlan -= dt;
        wall.advance(at.rolled());
        if (driveDirection == DriveDirection.FORWARDS && diagnosis.hasMissedSurface()) {
            retreat.start();
        }
        if (untilPlan <= 0) {
            untilPlan = path.isScanning() ? SCAN_PLAN_INTERVAL : PLAN_INTERVAL;
            driveDirection = DriveDirection.of(diagnosis);
            map.refresh(diagnosis, MEMORY, robot.boundingRadius() + UNSEEN_NEAR_BODY);
            plan();
            wallControl = measured();
        }
        move();
    }

    /** Finds the wall and, unless the robot scans, the direction of the path. */
    private void plan() {
        wall.follow(plannedDistance() + WALL_WITHIN);
        boolean searching = wall.isLost();
        boolean scanning = path.isScanning();
        if (searching && !scanning) {
            // The direction does not change: the robot drives straight on.
            wall.find(direction, plannedDistance() + FOUND_WITHIN);
        } else if (!scanning) {
            followWall();
        }
        path.update(robot, direction, driveDirection);
        if (searching) {
            state = FollowerState.SEARCH;
        } else if (!scanning) {
            state = path.isScanning() ? FollowerState.MEASURE : FollowerState.FOLLOW;
        }
        // Otherwise a scan continues, and one that began in a search remains a search.
    }

    /** Selects the direction along the wall; if there is none, the direction does not change. */
    private void followWall() {
        if (findOpenDirection()) {
            direction = directionFinder.direction();
        }
        leaveDeadEnd();
    }

    /**
     * Finds the first direction that keeps the planned distance from the wall. If there is none, the passage is narrow,
     * or the robot is so near to the wall that it does not get far enough away within the distance that it looks ahead.
     * If the planned distance is large, it then moves away step by step, or keeps the distance that it has.
     */
    private boolean findOpenDirection() {
        double least = Steering.turningRadius(robot);
        double planned = plannedDistance();
        // A passage that is less than twice as wide as the planned distance is passed along the wall on its left.
        double onRight = Math.min(planned, least + TURNING_MARGIN);
        if (findOpenDirection(new PathClearance(planned, onRight, robot.width() / 2))) {
            return true;
        }
        if (planned <= least + REACHED_WITHOUT_STEPS) {
            return findOpenDirection(PathClearance.around(least));
        }
        double distance = map.toSurface(at.x(), at.y());
        return findOpenDirection(PathClearance.around(Math.min(planned, distance + STEP_AWAY)))
                || findOpenDirection(PathClearance.around(Math.max(least, distance - MAY_COME_NEARER)))
                || findOpenDirection(PathClearance.around(least));
    }

    private boolean findOpenDirection(PathClearance clearance) {
        return directionFinder.find(at, wall.direction(), LOOK_AHEAD, clearance);
    }

    /**
     * Selects the surface on the left as the wall once the robot has turned back. In a narrow dead end the wall along
     * which it entered is still the nearest, and would lead it in again.
     */
    private void leaveDeadEnd() {
        boolean turned = Math.abs(offDirection()) < Steering.ASIDE;
        if (turned && wall.direction() - direction > TURNED_BACK) {
            wall.replace(direction + QUARTER, plannedDistance() + WALL_WITHIN);
        }
    }

    /** Returns the angle from the direction of motion to that of the path, radians, positive to the left. */
    private double offDirection() {
        return Angles.difference(driveDirection.leading(at.heading()), direction);
    }

    /**
     * Returns the planned distance from the centre to the nearest surface in the map, metres. It leaves room to turn,
     * and a margin around that of a small robot, even if a smaller distance is wanted.
     */
    private double plannedDistance() {
        double radius = Steering.turningRadius(robot);
        double least = Math.max(radius, Math.min(radius + TURNING_MARGIN, MAX_WITH_MARGIN));
        return Math.max(least, wantedCentreDistance - COARSENESS);
    }

    /** Returns the wanted distance, and that of the nearest surface in the map, measured in the same way. */
    private WallControl measured() {
        // The distances in the map are not computed for a search, because they take longest.
        double distance = state == FollowerState.SEARCH
                ? Double.POSITIVE_INFINITY
                : map.toSurface(at.x(), at.y()) - sideMountOffset + COARSENESS;
        boolean near = distance <= spec.distance() + WALL_WITHIN;
        return new WallControl(spec.distance(), near ? distance : Double.NaN, Double.NaN, Double.NaN);
    }

    /** Makes the first of these motions that is possible: a retreat, a scan, the path. */
    private void move() {
        if (retreats()) {
            v = -robot.speed();
            omega = 0;
        } else if (path.isScanning()) {
            path.advanceScan(robot, direction, driveDirection);
            v = 0;
            omega = path.scanSign() * robot.spinRate();
        } else {
            double off = offDirection();
            v = Math.abs(off) > Steering.ASIDE ? 0 : driveDirection.velocity(Steering.speed(robot, off));
            omega = Steering.turnRate(robot, off);
        }
    }

    /** Returns whether the robot retreats, which it does no further than the ground behind it is known to be free. */
    private boolean retreats() {
        if (retreat.isActive()) {
            retreat.advance(at.rolled());
            if (path.isBehindFree(robot)) {
                return true;
            }
            retreat.end();
        }
        return false;
    }

    /** {@return whether the robot has made no progress since this follower started, or for a long time} */
    public boolean isStuck() {
        return stuck;
    }

    /** {@return the wanted velocity, with a wall on the left} */
    public Velocity velocity() {
        return new Velocity(v, omega);
    }

    /** {@return the wanted distance and that of the last plan, with the wall's surfaces as the map has them} */
    public WallControl wallControl() {
        return wallControl;
    }

    /**
     * {@return the current state among those of the wall follower: FOLLOW, MEASURE while it turns to see more, or
     * SEARCH if it has no wall}
     */
    public FollowerState state() {
        return state;
    }
}
