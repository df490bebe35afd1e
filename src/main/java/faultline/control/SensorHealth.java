package faultline.control;

import java.util.Objects;

/**
 * The finding of a controller's diagnosis about one sensor.
 *
 * @param sensor its id
 * @param trust whether it is used
 * @param finding why it is not trusted, {@link SensorFinding#NONE} if it is
 * @param evidence against it, in [0, 1] in steps of a tenth: 0 for none, 1 for enough to stop trusting it
 * @param sinceTick the number of ticks before the one in which the trust changed last
 */
public record SensorHealth(String sensor, SensorTrust trust, SensorFinding finding, double evidence, long sinceTick) {

    /**
     * Creates a finding.
     *
     * @param sensor its id
     * @param trust whether it is used
     * @param finding why it is not trusted, {@link SensorFinding#NONE} if it is
     * @param evidence against it, in [0, 1] in steps of a tenth: 0 for none, 1 for enough to stop trusting it
     * @param sinceTick the number of ticks before the one in which the trust changed last
     * @throws NullPointerException if the sensor, the trust or the finding is null
     */
    public SensorHealth {
        Objects.requireNonNull(sensor, "sensor");
        Objects.requireNonNull(trust, "trust");
        Objects.requireNonNull(finding, "finding");
    }

    /**
     * {@return the health of a sensor without any evidence against it}
     *
     * @param sensor the id of the sensor
     */
    public static SensorHealth trusted(String sensor) {
        return new SensorHealth(sensor, SensorTrust.TRUSTED, SensorFinding.NONE, 0, 0);
    }

    /** {@return whether the sensor is used: it is trusted, or suspected only} */
    public boolean isTrusted() {
        return trust != SensorTrust.DISTRUSTED;
    }
}
