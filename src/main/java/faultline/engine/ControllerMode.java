package faultline.engine;

/** The thread of the controller; the trajectory is the same to the bit. */
public enum ControllerMode {
    /** On its own single-thread executor. */
    OWN_THREAD,
    /** On the simulation thread. */
    DIRECT
}
