package faultline.control;

import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import faultline.robot.WheelSpeeds;
import java.util.Objects;

/**
 * The voltages that a controller applies until its next decision, with its telemetry.
 *
 * @param leftVolts the voltage on the left motors; the supply limits it
 * @param rightVolts the voltage on the right motors; the supply limits it
 * @param telemetry the values that the controller shows
 */
public record Decision(double leftVolts, double rightVolts, Telemetry telemetry) {

    /**
     * Creates a decision.
     *
     * @param leftVolts the voltage on the left motors; the supply limits it
     * @param rightVolts the voltage on the right motors; the supply limits it
     * @param telemetry the values that the controller shows
     * @throws IllegalArgumentException if a voltage is not finite
     * @throws NullPointerException if there is no telemetry
     */
    public Decision {
        Objects.requireNonNull(telemetry, "a decision needs telemetry");
        if (!(Double.isFinite(leftVolts) && Double.isFinite(rightVolts))) {
            throw new IllegalArgumentException("voltages must be finite: " + leftVolts + ", " + rightVolts);
        }
    }

    /**
     * {@return the voltage on the motors on the side of the wall, volts}
     *
     * @param side the side of the wall
     */
    public double nearVolts(WallSide side) {
        return side == WallSide.LEFT ? leftVolts : rightVolts;
    }

    /**
     * {@return the voltage on the motors on the side away from the wall, volts}
     *
     * @param side the side of the wall
     */
    public double farVolts(WallSide side) {
        return side == WallSide.LEFT ? rightVolts : leftVolts;
    }

    /**
     * {@return a decision for a controller that computes velocities and names its state}
     *
     * @param robot the robot whose motors turn the velocity into voltages
     * @param velocity the velocity
     * @param state the name of the controller's state
     * @param why the reason for that state, may be empty
     * @throws IllegalArgumentException if the velocity is not finite
     * @throws NullPointerException if one of them is null; the message names it
     */
    public static Decision ofVelocity(RobotSpec robot, Velocity velocity, String state, String why) {
        Objects.requireNonNull(robot, "the robot of the decision is null");
        Objects.requireNonNull(velocity, "the velocity of the decision is null");
        Objects.requireNonNull(state, "the state of the decision is null");
        Objects.requireNonNull(why, "the why of the decision is null; it may be empty");
        Telemetry telemetry = new Telemetry(
                ControllerState.of(state),
                why,
                0,
                0,
                Telemetry.WallControl.NONE,
                Telemetry.EdgeTimes.NONE,
                Telemetry.Diagnosis.NONE);
        return ofVelocity(robot, WallSide.LEFT, velocity, telemetry);
    }

    /**
     * {@return a decision for a controller that computes as if the wall were on its left}
     *
     * @param robot the robot whose motors turn the velocity into voltages
     * @param side the side of the wall; on the right the sides of the robot are exchanged
     * @param velocity the velocity, positive to the wall's side
     * @param telemetry the values that the controller shows
     * @throws IllegalArgumentException if the velocity is not finite
     */
    public static Decision ofVelocity(RobotSpec robot, WallSide side, Velocity velocity, Telemetry telemetry) {
        MotorSpec motor = robot.motor();
        WheelSpeeds speeds = WheelSpeeds.of(velocity, robot.track());
        double near = motor.voltageFor(speeds.left());
        double far = motor.voltageFor(speeds.right());
        return side == WallSide.LEFT ? new Decision(near, far, telemetry) : new Decision(far, near, telemetry);
    }

    /**
     * {@return a decision as {@link #ofVelocity} does}
     *
     * @param robot the robot whose motors turn the velocity into voltages
     * @param v the linear velocity, in metres per second, positive ahead
     * @param omega the turn rate, in radians per second, positive to the left
     * @param state the name of the controller's state
     * @param why the reason for that state, may be empty
     * @deprecated {@link #ofVelocity} takes both velocities as one value.
     */
    @Deprecated(since = "0.1.0")
    public static Decision ofVelocities(RobotSpec robot, double v, double omega, String state, String why) {
        return ofVelocity(robot, new Velocity(v, omega), state, why);
    }
}
