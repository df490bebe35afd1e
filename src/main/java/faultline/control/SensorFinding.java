package faultline.control;

/** Why a sensor is not trusted. */
public enum SensorFinding {
    /** It is trusted. */
    NONE,
    /** It does not answer. */
    OFF,
    /** It reports exactly the same distance although the robot's motion must have changed it. */
    STUCK,
    /** Its readings scatter. */
    NOISY,
    /** Its readings appear and disappear. */
    INTERMITTENT,
    /** Its readings contradict its own, or those of several other sensors together. */
    INCONSISTENT,
    /** Its readings contradict those of other sensors. */
    CONTRADICTED,
    /** It does not see what other sensors predict. */
    BLIND,
    /** If the robot steers by it, it aligns itself with the wall repeatedly without progress. */
    MISLEADING
}
