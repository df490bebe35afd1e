package faultline.control;

import faultline.robot.DifferentialDrive;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;

/**
 * Dead reckoning from the follower's own commands through the motor's model: how far the robot has rolled and turned.
 * In the follower's frame, in which the wall is kept on the left.
 */
final class Odometer {

    private double leftSpeed;
    private double rightSpeed;
    private double heading;
    private double deltaDistance;
    private double deltaHeading;

    /** Lets a command have acted for some ticks. */
    void advance(RobotSpec robot, double v, double omega, double dt, long ticks) {
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

    /** All the turning so far, radians, positive to the left. */
    double heading() {
        return heading;
    }

    /** The way of the last {@link #advance}, metres. */
    double deltaDistance() {
        return deltaDistance;
    }

    /** The turn of the last {@link #advance}, radians. */
    double deltaHeading() {
        return deltaHeading;
    }

    /** The rate of turning now, radians per second. */
    double omega(RobotSpec robot) {
        return DifferentialDrive.angularVelocity(leftSpeed, rightSpeed, robot.track());
    }

    /**
     * How long the motors' lag lasts, seconds: a speed w that is no longer commanded still gives a way of w times this.
     * It is the sum of the decays of all ticks to come, which for short ticks is the motor's time constant.
     */
    static double motorLag(RobotSpec robot, double dt) {
        double decay = robot.motor().decay(dt);
        return dt * decay / (1 - decay);
    }
}
