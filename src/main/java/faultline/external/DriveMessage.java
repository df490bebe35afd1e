package faultline.external;

import faultline.control.Decision;
import faultline.control.Telemetry;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;

/**
 * A {@code drive} message: the voltages of the motors, and the state that the controller reports.
 *
 * @param leftVolts the voltage on the left motors
 * @param rightVolts the voltage on the right motors
 * @param state the name of the controller's state, empty if none is given
 * @param why the reason for that state, empty if none is given
 */
record DriveMessage(double leftVolts, double rightVolts, String state, String why) {

    /**
     * Reads a message, which has either {@code left_v} and {@code right_v} or {@code v_m_s} and {@code omega_rad_s};
     * velocities are converted to voltages by the robot's track and motors.
     */
    static DriveMessage read(MessageReader message, RobotSpec robot) throws ProtocolException {
        String state = Telemetry.limited(message.string("state", ""));
        String why = Telemetry.limited(message.string("why", ""));
        boolean volts = message.has("left_v") || message.has("right_v");
        boolean velocities = message.has("v_m_s") || message.has("omega_rad_s");
        if (volts == velocities) {
            throw new ProtocolException(volts ? ControllerProblem.BOTH_DRIVES : ControllerProblem.NO_DRIVE);
        }
        if (volts) {
            return new DriveMessage(message.number("left_v"), message.number("right_v"), state, why);
        }
        Velocity velocity = new Velocity(message.number("v_m_s"), message.number("omega_rad_s"));
        try {
            Decision decision = Decision.ofVelocity(robot, velocity, state, why);
            return new DriveMessage(decision.leftVolts(), decision.rightVolts(), state, why);
        } catch (IllegalArgumentException infinite) {
            throw new ProtocolException(ControllerProblem.TOO_FAST);
        }
    }
}
