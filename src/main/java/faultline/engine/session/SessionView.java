package faultline.engine.session;

/** What an interactive run shows to those who may not control it. Safe on any thread. */
public interface SessionView {

    /** {@return the latest frame and requests the next one; frames are made only on request} Wait-free. */
    SessionFrame frame();

    /** {@return the current status} */
    SessionStatus status();
}
