package faultline.engine.session;

/** A read-only view of an interactive run. Safe on any thread. */
public interface SessionView {

    /** {@return the latest frame and requests the next one; frames are made only on request} Wait-free. */
    SessionFrame frame();

    /** {@return the current status} */
    SessionStatus status();
}
