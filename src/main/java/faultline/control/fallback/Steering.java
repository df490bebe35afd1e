package faultline.control.fallback;

import faultline.robot.RobotSpec;

/**
 * Steers the robot into a direction. {@code off} is the angle from its direction of motion to that direction, radians,
 * positive to the left.
 */
final class Steering {

    /** If the direction is farther off than this, the robot turns on the spot, radians. */
    static final double ASIDE = StrictMath.toRadians(35);

    /**
     * The speed is this less the share of {@link #ASIDE} that the direction is off, at most 1, as a share of the
     * robot's.
     */
    private static final double FULL_SPEED = 1.3;

    /** The least speed while it drives, as a share of the robot's. */
    private static final double MIN_SPEED = 0.3;

    /** The free margin around the robot when it turns, metres. */
    private static final double CLEARANCE = 0.02;

    /** The turn rate by the angle that the direction is off, 1/s. */
    private static final double GAIN = 2.5;

    /**
     * The rate of a turn on the spot to a direction that is known to be free, as a multiple of the robot's turn rate.
     * It can be high because nothing has to be seen during the turn.
     */
    private static final double RETURN_RATE = 2;

    private Steering() {}

    /** Returns the radius that must be free about the centre to turn, metres. */
    static double turningRadius(RobotSpec robot) {
        return robot.boundingRadius() + CLEARANCE;
    }

    /** Returns the speed while the direction is off by at most {@link #ASIDE}, metres per second. */
    static double speed(RobotSpec robot, double off) {
        return robot.speed() * Math.max(MIN_SPEED, Math.min(1, FULL_SPEED - Math.abs(off) / ASIDE));
    }

    /** Returns the turn rate toward the direction, radians per second. */
    static double turnRate(RobotSpec robot, double off) {
        if (Math.abs(off) > ASIDE) {
            return Math.copySign(Math.min(RETURN_RATE * robot.turnRate(), robot.maxTurnRate()), off);
        }
        double rate = robot.spinRate();
        return Math.max(-rate, Math.min(rate, GAIN * off));
    }
}
