package faultline.control;

/**
 * What a controller's diagnosis thinks of one sensor.
 *
 * @param sensor its id
 * @param finding why it is not trusted, {@link SensorFinding#NONE} if it is
 * @param evidence against it, in [0, 1] in steps of a tenth: 0 for none, 1 for enough to stop trusting it
 * @param sinceTick the tick at which the finding was made
 */
public record SensorHealth(String sensor, SensorFinding finding, double evidence, long sinceTick) {

    /** Returns whether the sensor is trusted. */
    public boolean isTrusted() {
        return finding == SensorFinding.NONE;
    }
}
