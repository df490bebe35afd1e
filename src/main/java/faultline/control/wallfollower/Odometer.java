package faultline.control.wallfollower;

import faultline.control.Decision;
import faultline.control.Telemetry;
import faultline.control.WallSide;
import faultline.robot.DifferentialDrive;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;

/**
 * The commanded motion, and dead reckoning from it through the motor's model: how far the robot has rolled and turned.
 * In the follower's frame, in which the wall is kept on the left.
 */
final class Odometer {

    private double v;
    private double omega;
    private double leftSpeed;
    private double rightSpeed;
    private double heading;
    private double deltaDistance;
    private double deltaHeading;

    /**
     * Commands a motion until the next decision.
     *
     * @param newV metres per second, positive ahead
     * @param newOmega radians per second, positive to the left
     */
    void command(double newV, double newOmega) {
        v = newV;
        omega = newOmega;
    }

    /** Returns the voltages that command the motion, with what the follower shows of itself. */
    Decision decision(RobotSpec robot, WallSide side, Telemetry telemetry) {
        MotorSpec motor = robot.motor();
        double half = omega * robot.track() / 2;
        double near = motor.voltageFor(v - half);
        double far = motor.voltageFor(v + half);
        return side == WallSide.LEFT ? new Decision(near, far, telemetry) : new Decision(far, near, telemetry);
    }

    /** Takes it that the command has acted for some ticks. */
    void advance(RobotSpec robot, double dt, long ticks) {
        MotorSpec motor = robot.motor();
        double decay = motor.decay(dt);
        double half = omega * robot.track() / 2;
        deltaDistance = 0;
        deltaHeading = 0;
        for (long i = 0; i < ticks; i++) {
            leftSpeed = motor.step(leftSpeed, motor.voltageFor(v - half), decay);
            rightSpeed = motor.step(rightSpeed, motor.voltageFor(v + half), decay);
            deltaDistance += DifferentialDrive.linearVelocity(leftSpeed, rightSpeed) * dt;
            deltaHeading += DifferentialDrive.angularVelocity(leftSpeed, rightSpeed, robot.track()) * dt;
        }
        heading += deltaHeading;
    }

    /** Returns all turning so far, radians, positive to the left. */
    double heading() {
        return heading;
    }

    /** Returns the distance of the last {@link #advance}, metres. */
    double deltaDistance() {
        return deltaDistance;
    }

    /** Returns the turn of the last {@link #advance}, radians. */
    double deltaHeading() {
        return deltaHeading;
    }

    /** Returns the rate of turning now, radians per second. */
    double omega(RobotSpec robot) {
        return DifferentialDrive.angularVelocity(leftSpeed, rightSpeed, robot.track());
    }

    /**
     * Returns how long the motors' lag lasts, seconds: a speed w that is no longer commanded still gives a distance of
     * w times this. It is the sum of the decays of all ticks to come, which for short ticks is the motor's time
     * constant.
     */
    static double motorLag(RobotSpec robot, double dt) {
        double decay = robot.motor().decay(dt);
        return dt * decay / (1 - decay);
    }
}
