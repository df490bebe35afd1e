package faultline.control.wallfollower;

import faultline.control.ControllerSpec;
import faultline.control.Observation;
import faultline.control.PeriodicController;
import faultline.control.WallSide;
import faultline.robot.RobotSpec;

/**
 * What the follower knows at a decision: its sensors with what they remember, its own motion by dead reckoning, and how
 * far its readings can be trusted.
 */
final class StateEstimate {

    private static final double QUARTER_TURN = StrictMath.PI / 2;

    /** Two sensors see one wall if it would be this much nearer for one of them at most, metres. */
    private static final double SAME_WALL_TOLERANCE = 0.02;

    /** By how many deviations the nearest of many readings is nearer than their mean. */
    private static final double MINIMUM_BIAS_FACTOR = 3;

    /**
     * What is at the far front corner, or slipped out of the front cone, is turned from when it is this near to the
     * circle that the platform turns in, metres.
     */
    private static final double CORNER_CLEARANCE = 0.06;

    private final WallSide side;
    private double wantedDistance;
    private final Odometer odometer = new Odometer();
    private final FrontRangeMemory frontMemory = new FrontRangeMemory();
    private final LastSeenPoint lastSeenFront = new LastSeenPoint();
    private final LastSeenPoint lastSeenFrontLeft = new LastSeenPoint();
    private final LastSeenPoint lastSeenFrontRight = new LastSeenPoint();
    private final NoiseEstimator leftNoise = new NoiseEstimator();
    private final NoiseEstimator frontNoise = new NoiseEstimator();
    private final double controlPeriod;
    private Observation current;
    private SensorViews views;
    private SensorView currentFront = SensorView.NONE;
    private long lastTick;

    StateEstimate(ControllerSpec.WallFollowing spec) {
        side = spec.side();
        wantedDistance = spec.distance();
        controlPeriod = spec.period();
    }

    /** Takes another wanted distance, metres. */
    void setWantedDistance(double metres) {
        wantedDistance = metres;
    }

    /** Takes a new observation, up to which a command has acted. */
    void update(Observation observation) {
        odometer.advance(observation.robot(), observation.dt(), observation.tick() - lastTick);
        lastTick = observation.tick();
        current = observation;
        SensorViews fresh = SensorViews.of(observation, side);
        leftNoise.update(fresh.left().reading());
        frontNoise.update(fresh.front().reading());
        currentFront = fresh.front();
        frontMemory.update(currentFront, odometer.deltaDistance(), odometer.deltaHeading(), robot().width() / 2);
        views = fresh.withFront(frontMemory.withRememberedRange(currentFront));
    }

    /**
     * Returns whether something in the way, seen or remembered, will be within the guarded radius of the robot's centre
     * when it has rolled out.
     */
    boolean isFrontTargetWithinTurningCircle() {
        return frontMemory.nearest() + views.front().mountPosition().x() - stoppingDistance() <= guardedRadius();
    }

    /** Returns the radius about the robot's centre in which nothing may be when it turns, metres. */
    double guardedRadius() {
        return robot().boundingRadius() + CORNER_CLEARANCE;
    }

    /** Remembers what the sensors that look ahead see on a straight way. */
    void updateLastSeenPoints() {
        lastSeenFront.update(currentFront, odometer.deltaDistance());
        lastSeenFrontLeft.update(views.frontLeft(), odometer.deltaDistance());
        lastSeenFrontRight.update(views.frontRight(), odometer.deltaDistance());
    }

    /**
     * Whether something that was seen on a straight way, though it may be between the cones now, will be within a
     * distance of the robot's centre when it has rolled out. The nearest of many noisy readings is too near by some
     * deviations.
     */
    boolean isLastSeenPointWithin(double distance) {
        double nearest = Math.min(
                lastSeenFront.distanceAfter(stoppingDistance()),
                Math.min(
                        lastSeenFrontLeft.distanceAfter(stoppingDistance()),
                        lastSeenFrontRight.distanceAfter(stoppingDistance())));
        return nearest + MINIMUM_BIAS_FACTOR * noise() <= distance;
    }

    /** What was seen ahead is dealt with. */
    void clearFrontMemory() {
        frontMemory.clear();
        lastSeenFront.clear();
        lastSeenFrontLeft.clear();
        lastSeenFrontRight.clear();
    }

    /** Returns the commanded motion and what dead reckoning makes of it. */
    Odometer odometer() {
        return odometer;
    }

    SensorViews views() {
        return views;
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

    /** How long a decision holds, seconds. */
    double period() {
        return current.dt() * PeriodicController.ticksPerPeriod(controlPeriod, current.dt());
    }

    /** How long the motors' lag lasts, seconds. */
    double motorLag() {
        return Odometer.motorLag(robot(), current.dt());
    }

    /** The rate that the robot spins at, radians per second. */
    double turnRate() {
        return Math.min(robot().turnRate(), 2 * robot().motor().maxSpeed() / robot().track());
    }

    /** The standard deviation of the left sensor's noise as far as it has shown, metres. */
    double leftNoise() {
        return leftNoise.standardDeviation();
    }

    /** Returns whether the left sensor has seen enough for its noise to be known. */
    boolean isLeftNoiseKnown() {
        return leftNoise.isKnown();
    }

    /** The standard deviation of the readings' noise as far as any sensor in use has shown it, metres. */
    double noise() {
        return Math.max(leftNoise.standardDeviation(), frontNoise.standardDeviation());
    }

    /**
     * Returns the distance from the robot's centre to the mounting position of the sensor that faces the wall, metres.
     */
    double sideMountOffset() {
        return views.left().present() ? views.left().mountPosition().y() : robot().width() / 2;
    }

    /** From the robot's centre to the wall where the distance is as wanted, metres. */
    double wantedCentreDistance() {
        return wantedDistance + sideMountOffset();
    }

    /** Returns the distance that the robot still rolls after the command to stop, metres. */
    double stoppingDistance() {
        return robot().speed() * (motorLag() + current.dt());
    }

    /** Whether a wall ahead, however slanted, will be at the wanted distance when the robot has rolled out. */
    boolean isWallAheadWhileSearching() {
        return FrontWallEstimator.isWithin(
                wantedCentreDistance(),
                stoppingDistance(),
                views,
                FrontWallEstimator.MAX_SEARCH_SLANT,
                FrontWallEstimator.MAX_SEARCH_SLANT);
    }

    /** The same along a wall, which is itself no wall ahead: what the front left sensor sees of it says nothing. */
    boolean isWallAheadWhileFollowing() {
        boolean seesTheWall = views.left().detects()
                && views.frontLeft().wallDistance(QUARTER_TURN)
                        >= views.left().perpendicularDistance() - SAME_WALL_TOLERANCE;
        SensorViews ahead = seesTheWall ? views.withFrontLeft(SensorView.NONE) : views;
        return FrontWallEstimator.isWithin(
                wantedCentreDistance(),
                stoppingDistance(),
                ahead,
                FrontWallEstimator.MAX_LEFT_SLANT,
                FrontWallEstimator.MAX_RIGHT_SLANT);
    }
}
