package faultline.control.fallback;

import faultline.control.ControllerSpec;
import faultline.control.FollowerState;
import faultline.control.Telemetry.WallControl;
import faultline.control.diagnosis.DeadReckoning;
import faultline.control.diagnosis.EvidenceGrid;
import faultline.control.diagnosis.MountedCone;
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

    /** The time for which an observation counts, on the motion clock. */
    private static final int MEMORY = 1000;

    /** The time between two plans, in seconds. */
    private static final double PLANNING = 0.08;

    /** The time between two plans while the robot scans, in seconds: a scan ends as soon as enough has been seen. */
    private static final double SCAN_PLANNING = 0.04;

    /** The distance that it looks ahead along the wall, metres. */
    private static final double LOOK_AHEAD = 0.2;

    /** The distance by which it leaves a wall that is too near while it drives as far as it looks ahead, metres. */
    private static final double LEAVING = 0.1;

    /** The amount by which the distance may become less while the robot keeps it, metres. */
    private static final double KEEPING = 0.025;

    /** The free margin around the robot, metres. */
    private static final double CLEARANCE = 0.02;

    /** Ground within this of the turning circle is taken to be free, because no sensor can see it, metres. */
    private static final double NEAR = 0.05;

    /**
     * The amount by which the planned distance to the wall is less than the wanted one, because surfaces are enlarged
     * to whole cells, metres.
     */
    private static final double COARSENESS = 0.04;

    /** The amount by which the wall may be farther away than wanted, metres; surfaces beyond it are not the wall. */
    private static final double NEAR_WALL = 0.35;

    /** In a search, the amount by which the wall may be farther away than planned, metres. */
    private static final double FOUND_WALL = 0.1;

    /** A surface whose direction differs from that of the wall by at most this can be the wall, radians. */
    private static final double WALL_SECTOR = StrictMath.toRadians(75);

    /** After this distance without a wall the robot searches, metres. */
    private static final double LOST = 1.2;

    /** The length of the path that is examined, metres. */
    private static final double PATH = 0.6;

    /** The length of the path that must be known to drive on, metres. */
    private static final double NEEDED = 0.06;

    /** The length of the path that must be known after a scan, metres. */
    private static final double WORTHWHILE = 0.18;

    /** A sensor whose axis is farther than this from the direction of motion faces sideways, radians. */
    private static final double SIDEWAYS = StrictMath.toRadians(60);

    /**
     * A scan by a sensor that faces sideways also shows the path in a direction that is this far clockwise, radians:
     * when the robot has turned back, the wall is seen again and the direction changes a little.
     */
    private static final double SCAN_MARGIN = StrictMath.toRadians(20);

    /** The margin of a square that contains a lap around a pole at the wanted distance, metres. */
    private static final double LAP_MARGIN = 0.4;

    private static final double QUARTER = StrictMath.PI / 2;

    /** A direction that is this far clockwise from the wall leads back, radians. */
    private static final double TURNED_BACK = StrictMath.toRadians(240);

    private final SensorDiagnosis diagnosis;
    private ControllerSpec.WallFollowing spec;
    private final LocalMap map = new LocalMap();
    private final FreeDirectionFinder directionFinder = new FreeDirectionFinder(map);
    private final NoProgressDetector progress = new NoProgressDetector();
    /** Null before the first decision. */
    private RobotSpec robot;
    /** The distance from the centre to the sensor that faces the wall, which reads the wanted distance, metres. */
    private double sideMountOffset;
    /** The wanted distance from the centre to the wall, metres. */
    private double wantedCentreDistance;

    private DriveDirection driveDirection = DriveDirection.FORWARDS;
    private boolean stuck;
    private FollowerState state = FollowerState.FOLLOW;
    private double wall;
    private double direction;
    private double sinceWall;
    private double untilPlan;
    private final Scan scan = new Scan();
    private final Retreat retreat = new Retreat();
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
        this.spec = spec;
    }

    /**
     * Sets the wanted distance from the sensor that faces the wall to the wall, or from the side of the platform if no
     * sensor does.
     *
     * @param settings the settings, with the same side of the wall as before
     */
    public void configure(ControllerSpec.WallFollowing settings) {
        spec = settings;
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
        direction = atWall ? at().heading() : driveDirection.leading(at().heading());
        wall = direction + QUARTER;
        sinceWall = atWall ? LOST / 2 : LOST + 1;
        untilPlan = 0;
        scan.end();
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
        stuck |= progress.isStuck(at(), lap, robot.speed(), dt);
        untilPlan -= dt;
        sinceWall += Math.abs(at().rolled());
        if (driveDirection == DriveDirection.FORWARDS && diagnosis.hasMissedSurface()) {
            retreat.start();
        }
        if (untilPlan <= 0) {
            untilPlan = scan.isActive() ? SCAN_PLANNING : PLANNING;
            driveDirection = DriveDirection.of(diagnosis);
            map.refresh(diagnosis, diagnosis.sensors(), MEMORY, robot.boundingRadius() + NEAR);
            plan();
            wallControl = measured();
        }
        act();
    }

    private DeadReckoning at() {
        return diagnosis.reckoning();
    }

    /** Returns the radius that must be free about the centre to turn. */
    private double radius() {
        return robot.boundingRadius() + CLEARANCE;
    }

    private double knownAhead() {
        return known(direction);
    }

    private double known(double towards) {
        return directionFinder.known(at(), towards, PATH, robot.length() / 2, robot.width() / 2);
    }

    /**
     * Returns how far the ground behind the robot is known to be free. The robot has come from there, so the ground
     * that its body covered is known, except for the cells at the border.
     */
    private double knownBehind() {
        return directionFinder.known(
                at(),
                at().heading() + StrictMath.PI,
                NEEDED,
                robot.length() / 2,
                robot.width() / 2 - EvidenceGrid.CELL);
    }

    /** Returns the wanted distance, and that of the nearest surface in the map, measured in the same way. */
    private WallControl measured() {
        // The distances in the map are not computed for a search, because they take longest.
        double distance = state == FollowerState.SEARCH
                ? Double.NaN
                : map.toSurface(at().x(), at().y()) - sideMountOffset + COARSENESS;
        boolean near = distance <= spec.distance() + NEAR_WALL;
        return new WallControl(spec.distance(), near ? distance : Double.NaN, Double.NaN, Double.NaN);
    }

    /** Returns the wanted distance from the centre to the nearest surface in the map, metres. */
    private double wanted() {
        return wantedCentreDistance - COARSENESS;
    }

    private void plan() {
        double bearing = bearingOfWall(wall);
        if (!Double.isNaN(bearing)) {
            wall += Angles.difference(wall, bearing);
            sinceWall = 0;
        }
        if (sinceWall > LOST) {
            search();
            return;
        }
        if (scan.isActive()) {
            checkKnown();
            return;
        }
        double open = openDirection();
        direction = Double.isNaN(open) ? direction : open;
        leaveDeadEnd();
        checkKnown();
        state = scan.isActive() ? FollowerState.MEASURE : FollowerState.FOLLOW;
    }

    /**
     * Returns the first direction that keeps the wanted distance. If there is none, the passage is narrow, or the robot
     * is so near to the wall that it does not get far enough away within the distance that it looks ahead. With a large
     * wanted distance it then moves away step by step, or keeps the distance that it has.
     */
    private double openDirection() {
        double open = along(wanted());
        if (Double.isNaN(open) && diagnosis.reach().isLarge()) {
            double distance = map.toSurface(at().x(), at().y());
            open = along(Math.min(wanted(), distance + LEAVING));
            open = Double.isNaN(open) ? along(Math.max(radius(), distance - KEEPING)) : open;
        }
        return Double.isNaN(open) ? along(radius()) : open;
    }

    private double along(double distance) {
        return directionFinder.along(at(), wall, LOOK_AHEAD, distance);
    }

    /**
     * Selects the surface on the left as the wall once the robot has turned back. In a narrow dead end the wall along
     * which it entered is still the nearest, and would lead it in again.
     */
    private void leaveDeadEnd() {
        double turn = wall - direction;
        boolean turned =
                Math.abs(Angles.difference(driveDirection.leading(at().heading()), direction)) < Steering.ASIDE;
        if (turned && turn > TURNED_BACK) {
            double left = bearingOfWall(direction + QUARTER);
            wall = Double.isNaN(left) ? wall : left;
        }
    }

    /** Returns the direction of the nearest surface that can be the wall near a direction, NaN if there is none. */
    private double bearingOfWall(double near) {
        return map.bearingOfSurface(near, WALL_SECTOR, wanted() + NEAR_WALL);
    }

    /** Drives straight ahead, because there is no wall. */
    private void search() {
        state = FollowerState.SEARCH;
        if (!scan.isActive()) {
            double bearing = map.bearingOfSurface(direction, StrictMath.PI, wanted() + FOUND_WALL);
            if (!Double.isNaN(bearing)) {
                wall = bearing;
                sinceWall = 0;
            }
        }
        checkKnown();
    }

    private void checkKnown() {
        double known = knownAhead();
        if (scan.isActive()) {
            if (known >= WORTHWHILE && known(direction - scan.margin()) >= NEEDED) {
                scan.end();
            }
        } else if (known < NEEDED) {
            startScan();
        } else {
            scan.forget();
        }
    }

    /** Turns until the trusted sensor that needs to turn least has seen the nearest unknown place of the path. */
    private void startScan() {
        double best = Double.NaN;
        double margin = 0;
        for (int i = 0; i < diagnosis.sensors(); i++) {
            if (diagnosis.isTrusted(i)) {
                double turn = turnFor(diagnosis.cone(i), directionFinder.unknownX(), directionFinder.unknownY());
                if (Double.isNaN(best) || Math.abs(turn) < Math.abs(best)) {
                    best = turn;
                    margin = isSideways(diagnosis.cone(i)) ? SCAN_MARGIN : 0;
                }
            }
        }
        scan.start(best, margin, directionFinder.unknownX(), directionFinder.unknownY());
    }

    private boolean isSideways(MountedCone cone) {
        return Math.abs(Angles.difference(driveDirection.leading(0), cone.bearing())) > SIDEWAYS;
    }

    /** Returns the angle to turn until a cone's axis points at a place. */
    private double turnFor(MountedCone cone, double px, double py) {
        double bearing = StrictMath.atan2(py - at().y(), px - at().x());
        return Angles.difference(at().heading() + cone.bearing(), bearing);
    }

    private void act() {
        if (retreat.isActive()) {
            retreat.advance(at().rolled());
            if (knownBehind() >= NEEDED / 2) {
                v = -robot.speed();
                omega = 0;
                return;
            }
            retreat.end();
        }
        if (scan.isActive()) {
            if (scan.advance(at().turned())) {
                endScan();
            }
            v = 0;
            omega = scan.sign() * Steering.turnRate(robot);
            return;
        }
        double off = Angles.difference(driveDirection.leading(at().heading()), direction);
        v = Math.abs(off) > Steering.ASIDE ? 0 : driveDirection.velocity(Steering.speed(robot, off));
        omega = Steering.turnRate(robot, off);
    }

    /** Ends a scan, or continues it if its place has been seen but another place is still unknown. */
    private void endScan() {
        scan.end();
        double known = knownAhead();
        if (known >= NEEDED) {
            return;
        }
        if (scan.mayContinueAt(directionFinder.unknownX(), directionFinder.unknownY())) {
            startScan();
            return;
        }
        // Everything visible has been seen, so unknown places now count as surfaces.
        double far = known + radius();
        diagnosis.markUnseen(at().x() + far * StrictMath.cos(direction), at().y() + far * StrictMath.sin(direction));
        diagnosis.markUnseen(directionFinder.unknownX(), directionFinder.unknownY());
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
