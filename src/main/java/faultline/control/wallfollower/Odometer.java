package faultline.control.wallfollower;

import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import faultline.robot.WheelSpeeds;

/**
 * Computes from the commanded velocity and the model of the motors how far the robot has rolled and turned. Works in
 * the follower's frame, in which the wall is on the left.
 */
final class Odometer {

    private Velocity command = Velocity.ZERO;
    private WheelSpeeds wheelSpeeds = WheelSpeeds.ZERO;
    /** The robot and the tick, seconds, whose decay is known: an exponential takes longer than all the rest. */
    private RobotSpec motorOf;

    private double tickLength;
    private double decay;
    private double heading;
    private double deltaDistance;
    private double deltaHeading;

    /** Sets the velocity that is commanded until the next decision. */
    void setCommand(Velocity velocity) {
        command = velocity;
    }

    /** Updates the estimate: the command has acted for some ticks. */
    void advance(RobotSpec robot, double dt, long ticks) {
        MotorSpec motor = robot.motor();
        if (robot != motorOf || dt != tickLength) {
            motorOf = robot;
            tickLength = dt;
            decay = motor.decay(dt);
        }
        WheelSpeeds wanted = WheelSpeeds.of(command, robot.track());
        deltaDistance = 0;
        deltaHeading = 0;
        for (long i = 0; i < ticks; i++) {
            wheelSpeeds =
                    motor.step(wheelSpeeds, motor.voltageFor(wanted.left()), motor.voltageFor(wanted.right()), decay);
            Velocity velocity = wheelSpeeds.toVelocity(robot.track());
            deltaDistance += velocity.linear() * dt;
            deltaHeading += velocity.angular() * dt;
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
        return wheelSpeeds.toVelocity(robot.track()).angular();
    }

    /**
     * Returns how long the lag of the motors of the last {@link #advance} lasts, seconds: a speed w that is no longer
     * commanded still results in a distance of w times this. It is the sum of the decays of all later ticks, which for
     * short ticks is the motor's time constant.
     */
    double motorLag() {
        return tickLength * decay / (1 - decay);
    }
}
