package faultline.control;

/** Why a sensor is not trusted. */
public enum SensorFinding {
    /** It is trusted. */
    NONE,
    /** It gives no answer. */
    OFF,
    /** It reports the same distance to the last bit though the robot's motion must have changed it. */
    STUCK,
    /** Its readings scatter. */
    NOISY,
    /** Its readings come and go. */
    INTERMITTENT,
    /** What it reports contradicts what it reported before. */
    INCONSISTENT,
    /** What it reports contradicts what other sensors saw. */
    CONTRADICTED,
    /** It does not see what others see coming. */
    BLIND,
    /** By it the robot aligns itself with the wall again and again and gets nowhere. */
    MISLEADING
}
