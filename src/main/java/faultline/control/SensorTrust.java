package faultline.control;

/** How far a controller's diagnosis trusts a sensor. */
public enum SensorTrust {
    /** It is used. */
    TRUSTED,
    /** It is used, although there is evidence against it. */
    SUSPECTED,
    /** It is not used; the {@link SensorFinding} gives the reason. */
    DISTRUSTED
}
