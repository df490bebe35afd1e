package faultline.engine.session;

import faultline.engine.SimulationSetup;

/** A read-only view of an interactive run. Safe on any thread. */
public interface SessionView {

    /** {@return the setup of the run} Its timeline contains the commands that the run will execute by itself. */
    SimulationSetup setup();

    /** {@return the latest frame and requests the next one; frames are made only on request} Wait-free. */
    SessionFrame frame();

    /** {@return the current status} */
    SessionStatus status();

    /**
     * Sets the listener for changes that happen while the run is paused, instead of the one before. It is called on the
     * simulation thread after a frame or a status has been published, and must return quickly. Changes before the call
     * are not reported.
     *
     * @param listener the listener
     */
    void setPausedChangeListener(Runnable listener);
}
