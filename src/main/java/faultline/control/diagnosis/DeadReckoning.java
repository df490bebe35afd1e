package faultline.control.diagnosis;

import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;

/**
 * The robot's pose by dead reckoning, from the controller's voltages and the model of the motors. The frame has its
 * origin at the start of the run and the wall on the left.
 */
public final class DeadReckoning {

    /** Below this angle the series of sine and cosine to the fifth power are exact, radians. */
    private static final double SMALL_TURN = 0.02;

    private double x;
    private double y;
    private double heading;
    private double leftSpeed;
    private double rightSpeed;
    private double headingCos = 1;
    private double headingSin;
    private RobotSpec motorOf;
    private double decayDt;
    private double decay;
    private double rolled;
    private double turned;
    private double distance;
    private double turning;
    private double curvature;

    DeadReckoning() {}

    /**
     * Updates the pose after voltages have acted for some ticks.
     *
     * @param robot the robot as the controller believes it to be
     * @param leftVolts the voltage on the side next to the wall
     * @param rightVolts the voltage on the other side
     * @param dt the length of a tick, seconds
     * @param ticks the number of ticks
     */
    void advance(RobotSpec robot, double leftVolts, double rightVolts, double dt, long ticks) {
        MotorSpec motor = robot.motor();
        rolled = 0;
        turned = 0;
        if (robot != motorOf || dt != decayDt) {
            motorOf = robot;
            decayDt = dt;
            decay = motor.decay(dt);
        }
        for (long i = 0; i < ticks; i++) {
            leftSpeed = motor.step(leftSpeed, leftVolts, decay);
            rightSpeed = motor.step(rightSpeed, rightVolts, decay);
            double step = v() * dt;
            double turn = omega(robot) * dt + curvature * step;
            // The direction at the middle of the arc, to second order in the turn of a tick.
            double half = turn / 2;
            double shrink = 1 - half * half / 2;
            x += step * (headingCos * shrink - headingSin * half);
            y += step * (headingSin * shrink + headingCos * half);
            turn(turn);
            rolled += step;
            turned += turn;
            distance += Math.abs(step);
            turning += Math.abs(turn);
        }
    }

    /** Sets the curvature to the left that the motor model lacks, 1/m. */
    void setCurvature(double perMetre) {
        curvature = perMetre;
    }

    /** Turns the heading; by a small angle without trigonometric functions, up to rounding. */
    private void turn(double angle) {
        heading += angle;
        if (angle == 0) {
            return;
        }
        if (Math.abs(angle) > SMALL_TURN) {
            headingCos = StrictMath.cos(heading);
            headingSin = StrictMath.sin(heading);
            return;
        }
        double square = angle * angle;
        double cos = 1 - square / 2 * (1 - square / 12);
        double sin = angle * (1 - square / 6 * (1 - square / 20));
        double turnedCos = headingCos * cos - headingSin * sin;
        double turnedSin = headingSin * cos + headingCos * sin;
        // One step of Newton's method keeps the length at 1.
        double scale = (3 - turnedCos * turnedCos - turnedSin * turnedSin) / 2;
        headingCos = turnedCos * scale;
        headingSin = turnedSin * scale;
    }

    /**
     * Returns the position ahead of the start.
     *
     * @return metres
     */
    public double x() {
        return x;
    }

    /**
     * Returns the position to the left of the start.
     *
     * @return metres
     */
    public double y() {
        return y;
    }

    /**
     * Returns the total turn.
     *
     * @return radians, positive to the left, not normalised
     */
    public double heading() {
        return heading;
    }

    /** Returns the cosine of the heading. */
    double headingCos() {
        return headingCos;
    }

    /** Returns the sine of the heading. */
    double headingSin() {
        return headingSin;
    }

    /**
     * Returns the distance rolled in the last step.
     *
     * @return metres, negative backwards
     */
    public double rolled() {
        return rolled;
    }

    /**
     * Returns the turn of the last step.
     *
     * @return radians, positive to the left
     */
    public double turned() {
        return turned;
    }

    /** {@return the total distance rolled, forwards and backwards, metres} */
    public double distance() {
        return distance;
    }

    /** Returns the total angle turned in both directions, radians. */
    double turning() {
        return turning;
    }

    /**
     * Returns the current turn rate.
     *
     * @param robot the robot as the controller believes it to be
     * @return radians per second, positive to the left
     */
    public double omega(RobotSpec robot) {
        return (rightSpeed - leftSpeed) / robot.track();
    }

    /**
     * Returns the current linear velocity.
     *
     * @return metres per second
     */
    public double v() {
        return (leftSpeed + rightSpeed) / 2;
    }
}
