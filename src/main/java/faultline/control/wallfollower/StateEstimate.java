package faultline.control.wallfollower;

import faultline.control.ControllerSpec;
import faultline.control.Observation;
import faultline.control.Odometer;
import faultline.control.PeriodicController;
import faultline.control.Threshold;
import faultline.control.Thresholds;
import faultline.control.WallSide;
import faultline.control.wallfollower.SensorViews.Direction;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;

/**
 * The follower's knowledge at a decision: its sensors with what they remember, its motion by dead reckoning, and the
 * noise of its readings.
 */
final class StateEstimate {

    private static final double QUARTER_TURN = StrictMath.PI / 2;

    /** Two sensors see the same wall if the distances that they give differ by at most this, metres. */
    private static final double SAME_WALL_TOLERANCE = 0.02;

    /** A robot that turns must pass an object on the wall's side at this distance, metres. */
    private static final double NEAR_SIDE_CLEARANCE = 0.03;

    /** An object beside the path is nearer than the followed wall by at least this, metres. */
    private static final double NEARER_THAN_WALL = 0.03;

    /**
     * A wall that is wanted within this of the circle that the robot's corners describe could be taken for an object in
     * the way, metres.
     */
    private static final double NEAR_WALL = 0.09;

    /** The number of standard deviations by which the nearest of many readings is nearer than their mean. */
    private static final double MINIMUM_BIAS_FACTOR = 3;

    /** The directions of the sensors that look ahead. */
    private static final Direction[] AHEAD = {Direction.FRONT, Direction.FRONT_LEFT, Direction.FRONT_RIGHT};

    private double wantedDistance;
    private Thresholds thresholds;
    private final SensorViews views;
    private final Odometer odometer;
    private final FrontRangeMemory frontMemory = new FrontRangeMemory();
    private final BlindSpotMemory frontLeftMemory = new BlindSpotMemory();
    private final BlindSpotMemory leftMemory = new BlindSpotMemory();
    private final LastSeenPoint[] lastSeen = {new LastSeenPoint(), new LastSeenPoint(), new LastSeenPoint()};
    private final NoiseEstimator leftNoise = new NoiseEstimator();
    private final NoiseEstimator frontNoise = new NoiseEstimator();
    private final double controlPeriod;
    private Observation current;
    private SensorView left;
    /** The front sensor with what it remembers. */
    private SensorView front;

    private SensorView currentFront = SensorView.NONE;
    private SensorView frontLeft;
    private SensorView frontRight;
    private SensorView right;
    private double stoppingDistance;

    /** Creates an estimate whose motion an odometer knows; its owner updates it before each observation. */
    StateEstimate(ControllerSpec.WallFollowing spec, Odometer odometer) {
        this.odometer = odometer;
        views = new SensorViews(spec.side());
        configure(spec);
        controlPeriod = spec.period();
    }

    /** Sets the wanted distance and the thresholds. */
    final void configure(ControllerSpec.WallFollowing spec) {
        wantedDistance = spec.distance();
        thresholds = spec.thresholds();
    }

    Thresholds thresholds() {
        return thresholds;
    }

    /** Processes an observation. */
    void update(Observation observation) {
        current = observation;
        stoppingDistance = robot().speed() * (motorLag() + current.dt());
        views.update(observation);
        left = views.facing(Direction.LEFT);
        currentFront = views.facing(Direction.FRONT);
        frontLeft = views.facing(Direction.FRONT_LEFT);
        frontRight = views.facing(Direction.FRONT_RIGHT);
        right = views.facing(Direction.RIGHT);
        leftNoise.update(left.reading());
        frontNoise.update(currentFront.reading());
        frontMemory.update(currentFront, odometer.deltaDistance(), odometer.deltaHeading(), robot().width() / 2);
        front = frontMemory.withRememberedRange(currentFront);
        double rolled = odometer.deltaDistance();
        double turn = odometer.deltaHeading();
        frontLeftMemory.update(frontLeft, left, currentFront, seesNearWall(), rolled, turn);
        leftMemory.update(left, SensorView.NONE, frontLeft, false, rolled, turn);
    }

    /**
     * Returns whether an obstacle ahead, seen or remembered, will be within the guarded radius of the robot's centre
     * when the robot has stopped.
     */
    boolean isFrontTargetWithinTurningCircle() {
        return frontMemory.nearest() + front.mountPosition().x() - stoppingDistance() <= guardedRadius();
    }

    /**
     * Returns whether an object is so near that the robot could run into it: the front left sensor sees it, or has seen
     * it and it is now between two cones. An object that is not much nearer than the followed wall does not count.
     */
    boolean isNearSideObjectWithinTurningCircle() {
        return frontLeft.detectsWithin(nearSideRadius()) || isWithinTurningCircle(frontLeftMemory);
    }

    /** Returns whether the followed wall has left the left sensor's cone so near that the robot could run into it. */
    boolean isLostWallWithinTurningCircle() {
        return isWithinTurningCircle(leftMemory);
    }

    /** An object that is nearer than the robot's corners does not count: a turn would swing one of them into it. */
    private boolean isWithinTurningCircle(BlindSpotMemory memory) {
        double distance = memory.distanceAfter(stoppingDistance());
        return distance <= nearSideRadius() && distance > robot().boundingRadius();
    }

    private double nearSideRadius() {
        return Math.min(robot().boundingRadius() + NEAR_SIDE_CLEARANCE, wantedCentreDistance() - NEARER_THAN_WALL);
    }

    /** Returns the radius about the robot's centre in which nothing may be when it turns, metres. */
    double guardedRadius() {
        return robot().boundingRadius() + thresholds.get(Threshold.TURN_CLEARANCE);
    }

    /** Remembers what the sensors that look ahead see during straight motion. */
    void updateLastSeenPoints() {
        for (int i = 0; i < lastSeen.length; i++) {
            lastSeen[i].update(views.facing(AHEAD[i]), odometer.deltaDistance());
        }
    }

    /**
     * Returns whether a point that was seen during straight motion, even if it is now between the cones, will be within
     * a distance of the robot's centre when the robot has stopped. The nearest of many noisy readings is too near by
     * some standard deviations.
     */
    boolean isLastSeenPointWithin(double distance) {
        double nearest = Reading.NOTHING;
        for (LastSeenPoint point : lastSeen) {
            nearest = Math.min(nearest, point.distanceAfter(stoppingDistance));
        }
        return nearest + MINIMUM_BIAS_FACTOR * noise() <= distance;
    }

    /** Forgets what was seen ahead. */
    void clearFrontMemory() {
        frontMemory.clear();
        frontLeftMemory.clear();
        leftMemory.clear();
        for (LastSeenPoint point : lastSeen) {
            point.clear();
        }
    }

    /**
     * Forgets all that the front left sensor has seen if it now sees the wall that the robot has been aligned with,
     * near the robot: the spin has carried that wall through the cone.
     */
    void forgetWallOfSpin() {
        if (seesNearWall()) {
            frontLeftMemory.clear();
        }
    }

    /** Returns whether the left sensor and the front left one see the same wall, which is wanted near the robot. */
    private boolean seesNearWall() {
        return wantedCentreDistance() <= robot().boundingRadius() + NEAR_WALL
                && left.detects()
                && Math.abs(frontLeftBehindWall()) <= SAME_WALL_TOLERANCE;
    }

    /** Returns whether the left sensor sees a wall, and the front left one that wall or nothing as near. */
    private boolean seesNothingBeforeWall() {
        return left.detects() && frontLeftBehindWall() >= -SAME_WALL_TOLERANCE;
    }

    /**
     * Returns by how much a wall beside the robot that gives the front left reading is farther than one that gives the
     * left reading, metres.
     */
    private double frontLeftBehindWall() {
        return frontLeft.wallDistance(QUARTER_TURN) - left.perpendicularDistance();
    }

    /** Returns the odometer of the robot's motion. */
    Odometer odometer() {
        return odometer;
    }

    /** Returns the sensor that faces the wall; this and the front sensor follow most walls. */
    SensorView left() {
        return left;
    }

    /** Returns the sensor that distinguishes an obtuse corner ahead from a square one. */
    SensorView frontLeft() {
        return frontLeft;
    }

    /** Returns the sensor that an acute inner corner needs. */
    SensorView frontRight() {
        return frontRight;
    }

    /** Returns the sensor that is used only in a search. */
    SensorView right() {
        return right;
    }

    RobotSpec robot() {
        return current.robot();
    }

    /** Returns the length of a tick, seconds. */
    double dt() {
        return current.dt();
    }

    long tick() {
        return current.tick();
    }

    /** Returns how long a decision holds, seconds. */
    double period() {
        return current.dt() * PeriodicController.ticksPerPeriod(controlPeriod, current.dt());
    }

    /** Returns how long the motors' lag lasts, seconds. */
    double motorLag() {
        return odometer.motorLag();
    }

    /** Returns the rate at which the robot spins, radians per second. */
    double turnRate() {
        return robot().spinRate();
    }

    /** Returns the estimated standard deviation of the left sensor's noise, metres. */
    double leftNoise() {
        return leftNoise.standardDeviation();
    }

    /** Returns whether the left sensor has enough readings for an estimate of its noise. */
    boolean isLeftNoiseKnown() {
        return leftNoise.isKnown();
    }

    /** Returns the greatest estimated standard deviation of the noise of the sensors in use, metres. */
    double noise() {
        return Math.max(leftNoise.standardDeviation(), frontNoise.standardDeviation());
    }

    /**
     * Returns the distance from the robot's centre to the mounting position of the sensor that faces the wall, metres.
     */
    double sideMountOffset() {
        return sideMountOffset(left, robot());
    }

    private static double sideMountOffset(SensorView left, RobotSpec robot) {
        return left.present() ? left.mountPosition().y() : robot.width() / 2;
    }

    /** Returns the distance from the robot's centre to the followed wall, or the corner, at a reading, metres. */
    double centreDistance(double reading) {
        return centreDistance(reading, left, robot());
    }

    private static double centreDistance(double reading, SensorView left, RobotSpec robot) {
        return Math.max(robot.width() / 2, reading + sideMountOffset(left, robot));
    }

    /** Returns {@link #sideMountOffset()} of a robot whose sensors all answer, unless they are switched off, metres. */
    static double sideMountOffset(WallSide side, RobotSpec robot) {
        return sideMountOffset(SensorViews.facing(Direction.LEFT, side, robot), robot);
    }

    /** Returns the distance from a robot's centre to the wall if a follower holds its wanted distance, metres. */
    static double wantedCentreDistance(ControllerSpec.WallFollowing spec, RobotSpec robot) {
        return centreDistance(spec.distance(), SensorViews.facing(Direction.LEFT, spec.side(), robot), robot);
    }

    /** Returns the distance from the robot's centre to the wall if the reading is as wanted, metres. */
    double wantedCentreDistance() {
        return wantedDistance + sideMountOffset();
    }

    /** Returns the distance from the robot's centre at which a wall ahead ends a state, metres. */
    double aheadDistance() {
        return wantedCentreDistance() + thresholds.get(Threshold.AHEAD_MARGIN);
    }

    /** Returns the distance that the robot still rolls after the command to stop, metres. */
    double stoppingDistance() {
        return stoppingDistance;
    }

    /** Returns whether a wall ahead, at any slant, will be at its distance when the robot has stopped. */
    boolean isWallAheadWhileSearching() {
        return new FrontWallEstimator(front, frontLeft, frontRight)
                .isWithin(
                        aheadDistance(),
                        stoppingDistance(),
                        FrontWallEstimator.MAX_SEARCH_SLANT,
                        FrontWallEstimator.MAX_SEARCH_SLANT);
    }

    /**
     * Returns the same along a wall, which does not count as a wall ahead: the front left sensor's reading of it is
     * ignored. A margin for walls ahead counts only at the wanted distance: a robot that still approaches the followed
     * wall has that wall ahead, too.
     */
    boolean isWallAheadWhileFollowing(boolean atWantedDistance) {
        double margin = thresholds.get(Threshold.AHEAD_MARGIN);
        return new FrontWallEstimator(front, seesNothingBeforeWall() ? SensorView.NONE : frontLeft, frontRight)
                .isWithin(
                        wantedCentreDistance() + (atWantedDistance ? margin : Math.min(0, margin)),
                        stoppingDistance(),
                        FrontWallEstimator.MAX_LEFT_SLANT,
                        FrontWallEstimator.MAX_RIGHT_SLANT);
    }
}
