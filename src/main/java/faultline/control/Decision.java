package faultline.control;

import faultline.robot.RobotSpec;

/**
 * The voltages that a controller applies until its next decision, with its telemetry.
 *
 * @param leftVolts on the left motors; the supply limits it
 * @param rightVolts on the right motors; the supply limits it
 * @param telemetry what the controller shows of its working
 */
public record Decision(double leftVolts, double rightVolts, Telemetry telemetry) {

    /**
     * Creates a decision.
     *
     * @param leftVolts on the left motors; the supply limits it
     * @param rightVolts on the right motors; the supply limits it
     * @param telemetry what the controller shows of its working
     * @throws IllegalArgumentException if a voltage is not finite
     */
    public Decision {
        if (!(Double.isFinite(leftVolts) && Double.isFinite(rightVolts))) {
            throw new IllegalArgumentException("voltages must be finite: " + leftVolts + ", " + rightVolts);
        }
    }

    /**
     * {@return a decision for a controller that computes velocities and names its state}
     *
     * @param robot whose motors turn velocities into voltages
     * @param v forward, metres per second
     * @param omega the turn rate, radians per second, positive to the left
     * @param state the name of the controller's state
     * @param why the reason for that state, may be empty
     */
    public static Decision ofVelocities(RobotSpec robot, double v, double omega, String state, String why) {
        double half = omega * robot.track() / 2;
        Telemetry telemetry = new Telemetry(
                ControllerState.of(state),
                why,
                0,
                0,
                Telemetry.WallControl.NONE,
                Telemetry.EdgeTimes.NONE,
                Telemetry.Diagnosis.NONE);
        return new Decision(robot.motor().voltageFor(v - half), robot.motor().voltageFor(v + half), telemetry);
    }
}
