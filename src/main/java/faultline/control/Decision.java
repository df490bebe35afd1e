package faultline.control;

/**
 * What the controller wants of the motors until its next decision, and what it says of itself.
 *
 * @param leftVolts on the left motors; the supply limits it
 * @param rightVolts on the right motors; the supply limits it
 * @param telemetry what the controller shows of its working
 */
public record Decision(double leftVolts, double rightVolts, Telemetry telemetry) {

    public Decision {
        if (!(Double.isFinite(leftVolts) && Double.isFinite(rightVolts))) {
            throw new IllegalArgumentException("voltages must be finite: " + leftVolts + ", " + rightVolts);
        }
    }
}
