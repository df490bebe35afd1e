package faultline.control;

import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.robot.WheelSpeeds;

/**
 * Computes from the voltages and the model of the motors how far the robot has rolled and turned. Works in a frame in
 * which the wall is on the left.
 */
public final class Odometer {

    /**
     * The robot and the length of a tick, seconds, for which the decay is stored: computing an exponential takes longer
     * than everything else.
     */
    private RobotSpec motorOf;

    private MotorSpec motor;
    private double tickLength;
    private double decay;
    private double track = 1;
    private double leftSpeed;
    private double rightSpeed;
    private double stepDistance;
    private double stepTurn;
    private double earlierHeading;
    private double deltaDistance;
    private double deltaHeading;

    /** Creates an odometer of a robot at rest. */
    public Odometer() {}

    /**
     * Sets the speeds of the wheels of a robot that already moves.
     *
     * @param speeds the speeds, those of the side next to the wall as the left ones
     */
    public void setWheels(WheelSpeeds speeds) {
        leftSpeed = speeds.left();
        rightSpeed = speeds.right();
    }

    /** {@return the speeds of the wheels now, those of the side next to the wall as the left ones} */
    public WheelSpeeds wheels() {
        return new WheelSpeeds(leftSpeed, rightSpeed);
    }

    /**
     * Updates the estimate after voltages have acted for some ticks.
     *
     * @param robot the robot as the controller believes it to be
     * @param leftVolts the voltage on the side next to the wall
     * @param rightVolts the voltage on the other side
     * @param dt the length of a tick, seconds
     * @param ticks the number of ticks
     */
    public void advance(RobotSpec robot, double leftVolts, double rightVolts, double dt, long ticks) {
        begin(robot, dt);
        for (long i = 0; i < ticks; i++) {
            step(leftVolts, rightVolts);
        }
    }

    /**
     * Begins an update. It consists of all steps until the next update begins.
     *
     * @param robot the robot as the controller believes it to be
     * @param dt the length of a tick, seconds
     */
    public void begin(RobotSpec robot, double dt) {
        if (robot != motorOf || dt != tickLength) {
            motorOf = robot;
            motor = robot.motor();
            track = robot.track();
            tickLength = dt;
            decay = motor.decay(dt);
        }
        earlierHeading += deltaHeading;
        deltaDistance = 0;
        deltaHeading = 0;
    }

    /**
     * Updates the estimate after voltages have acted for a tick.
     *
     * @param leftVolts the voltage on the side next to the wall
     * @param rightVolts the voltage on the other side
     */
    public void step(double leftVolts, double rightVolts) {
        leftSpeed = motor.step(leftSpeed, leftVolts, decay);
        rightSpeed = motor.step(rightSpeed, rightVolts, decay);
        stepDistance = v() * tickLength;
        stepTurn = omega() * tickLength;
        deltaDistance += stepDistance;
        deltaHeading += stepTurn;
    }

    /** {@return the distance of the last tick, metres, negative backwards} */
    public double stepDistance() {
        return stepDistance;
    }

    /** {@return the turn of the last tick, radians, positive to the left} */
    public double stepTurn() {
        return stepTurn;
    }

    /** {@return all turning so far, radians, positive to the left} */
    public double heading() {
        return earlierHeading + deltaHeading;
    }

    /** {@return the distance of the last update, metres, negative backwards} */
    public double deltaDistance() {
        return deltaDistance;
    }

    /** {@return the turn of the last update, radians, positive to the left} */
    public double deltaHeading() {
        return deltaHeading;
    }

    /** {@return the linear velocity now, metres per second} */
    public double v() {
        return (leftSpeed + rightSpeed) / 2;
    }

    /** {@return the rate of turning now, radians per second, positive to the left} */
    public double omega() {
        return (rightSpeed - leftSpeed) / track;
    }

    /**
     * {@return the duration of the lag of the motors in the last update, seconds} A speed w that is no longer commanded
     * still results in a distance of w times this. It is the sum of the decays of all later ticks, which for short
     * ticks is the motor's time constant.
     */
    public double motorLag() {
        return tickLength * decay / (1 - decay);
    }
}
