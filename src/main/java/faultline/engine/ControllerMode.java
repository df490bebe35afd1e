package faultline.engine;

/** Where the controller runs; the trajectory is the same, to the bit. */
public enum ControllerMode {
    /** On its own single-thread executor, handed to and from in lock-step. */
    OWN_THREAD,
    /** Called directly by the world thread. */
    DIRECT
}
