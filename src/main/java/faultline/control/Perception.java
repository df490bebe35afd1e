package faultline.control;

import faultline.robot.RobotSpec;

/**
 * What the follower knows at a decision: its sensors with what they remember, its own motion by dead reckoning, and how far its readings
 * can be trusted.
 */
final class Perception {

    private static final double QUARTER = StrictMath.PI / 2;

    /** Two sensors see one wall if it would be this much nearer for one of them at most, metres. */
    private static final double SAME_WALL = 0.02;

    /** By how many deviations the nearest of many readings is nearer than their mean. */
    private static final double NEAREST_OF_MANY = 3;

    private final Hand hand;
    private final double wantedDistance;
    private final Odometer odometer = new Odometer();
    private final FrontMemory frontMemory = new FrontMemory();
    private final Glimpse ahead = new Glimpse();
    private final Glimpse aheadLeft = new Glimpse();
    private final Glimpse aheadRight = new Glimpse();
    private final NoiseMeter leftNoise = new NoiseMeter();
    private final NoiseMeter frontNoise = new NoiseMeter();
    private final double controlPeriod;
    private Observation now;
    private Sight sight;
    private Eye frontNow = Eye.NONE;
    private long lastTick;

    Perception(ControllerSpec.WallFollowing spec) {
        hand = spec.hand();
        wantedDistance = spec.distance();
        controlPeriod = spec.period();
    }

    /** Takes a new observation, up to which a command has acted. */
    void look(Observation observation, double v, double omega) {
        odometer.advance(observation.robot(), v, omega, observation.dt(), observation.tick() - lastTick);
        lastTick = observation.tick();
        now = observation;
        Sight fresh = Sight.of(observation, hand);
        leftNoise.learn(fresh.left().reading());
        frontNoise.learn(fresh.front().reading());
        frontNow = fresh.front();
        frontMemory.update(frontNow, odometer.rolled(), odometer.turned(), robot().width() / 2);
        sight = fresh.withFront(frontMemory.fill(frontNow));
    }

    /** Whether something in the way, seen or remembered, will be within a distance of the robot's centre when it has rolled out. */
    boolean inTheWay(double distance) {
        return frontMemory.nearest() + sight.front().seat().x() - stopping() <= distance;
    }

    /** Remembers what the sensors that look ahead see on a straight way. */
    void glimpse() {
        ahead.update(frontNow, rolled());
        aheadLeft.update(sight.frontLeft(), rolled());
        aheadRight.update(sight.frontRight(), rolled());
    }

    /**
     * Whether something that was seen on a straight way, though it may be between the cones now, will be within a distance of the robot's
     * centre when it has rolled out. The nearest of many noisy readings is too near by some deviations.
     */
    boolean glimpsedWithin(double distance) {
        double nearest = Math.min(ahead.distanceAfter(stopping()),
                Math.min(aheadLeft.distanceAfter(stopping()), aheadRight.distanceAfter(stopping())));
        return nearest + NEAREST_OF_MANY * noise() <= distance;
    }

    /** What was seen ahead is dealt with. */
    void forgetAhead() {
        frontMemory.forget();
        ahead.forget();
        aheadLeft.forget();
        aheadRight.forget();
    }

    Sight sight() {
        return sight;
    }

    RobotSpec robot() {
        return now.robot();
    }

    long tick() {
        return now.tick();
    }

    /** How long a decision holds, seconds. */
    double period() {
        return now.dt() * Periodic.ticks(controlPeriod, now.dt());
    }

    /** All the turning so far, radians, positive to the left. */
    double heading() {
        return odometer.heading();
    }

    /** The way since the last decision, metres. */
    double rolled() {
        return odometer.rolled();
    }

    /** The turn since the last decision, radians. */
    double turned() {
        return odometer.turned();
    }

    /** The rate of turning now, radians per second. */
    double omega() {
        return odometer.omega(robot());
    }

    /** How long the motors' lag lasts, seconds. */
    double lag() {
        return Odometer.lag(robot(), now.dt());
    }

    /** The rate that the robot spins at, radians per second. */
    double turnRate() {
        return Math.min(robot().turnRate(), 2 * robot().motor().maxSpeed() / robot().track());
    }

    /** The standard deviation of the left sensor's noise as far as it has shown, metres. */
    double leftNoise() {
        return leftNoise.deviation();
    }

    /** The standard deviation of the readings' noise as far as any sensor in use has shown it, metres. */
    double noise() {
        return Math.max(leftNoise.deviation(), frontNoise.deviation());
    }

    /** From the robot's centre to the seat of the sensor that faces the wall, metres. */
    double seat() {
        return sight.left().present() ? sight.left().seat().y() : robot().width() / 2;
    }

    /** From the robot's centre to the wall where the distance is as wanted, metres. */
    double wantedRadius() {
        return wantedDistance + seat();
    }

    /** The way that the robot still rolls after it is told to stop, metres. */
    double stopping() {
        return robot().speed() * (lag() + now.dt());
    }

    /** Whether a wall ahead, however slanted, will be at the wanted distance when the robot has rolled out. */
    boolean wallAheadInTheOpen() {
        return WallAhead.isWithin(wantedRadius(), stopping(), sight, WallAhead.MOST_IN_THE_OPEN, WallAhead.MOST_IN_THE_OPEN);
    }

    /** The same along a wall, which is itself no wall ahead: what the front left sensor sees of it says nothing. */
    boolean wallAheadBesideAWall() {
        boolean seesTheWall = sight.left().sees() && sight.frontLeft().wallDistance(QUARTER) >= sight.left().squareDistance() - SAME_WALL;
        Sight ahead = seesTheWall ? sight.withFrontLeft(Eye.NONE) : sight;
        return WallAhead.isWithin(wantedRadius(), stopping(), ahead, WallAhead.MOST_LEFT, WallAhead.MOST_RIGHT);
    }
}
