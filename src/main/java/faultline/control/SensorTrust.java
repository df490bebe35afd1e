package faultline.control;

/** The trust of a controller's diagnosis in a sensor. */
public enum SensorTrust {
    /** It is used. */
    TRUSTED,
    /** It is used, although there is evidence against it. */
    SUSPECTED,
    /** It is not used; the {@link SensorFinding} gives the reason. */
    DISTRUSTED
}
