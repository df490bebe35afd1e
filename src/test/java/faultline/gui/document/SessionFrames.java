package faultline.gui.document;

import faultline.engine.session.SessionFrame;
import faultline.engine.session.SessionView;
import faultline.gui.Await;
import faultline.gui.GuiRobot;
import java.awt.EventQueue;
import java.util.Optional;
import java.util.function.Predicate;

/** Reads the frames of the session of a workspace, and waits for them. Any thread of a test may call the methods. */
public final class SessionFrames {

    private SessionFrames() {}

    /** Returns the latest frame and requests the next one; empty if no scenario is open. */
    public static Optional<SessionFrame> poll(Workspace workspace) {
        return EventQueue.isDispatchThread()
                ? workspace.session().map(SessionView::frame)
                : GuiRobot.callOnEdt(() -> workspace.session().map(SessionView::frame));
    }

    /** Returns the latest frame of an open scenario and requests the next one. */
    public static SessionFrame frame(Workspace workspace) {
        return poll(workspace).orElseThrow();
    }

    /** Returns the tick of the latest frame. */
    public static long tick(Workspace workspace) {
        return frame(workspace).snapshot().tick();
    }

    /** Returns the trajectory hash of the latest frame. */
    public static long trajectoryHash(Workspace workspace) {
        return frame(workspace).frame().trajectoryHash();
    }

    /** Waits until a scenario is open. */
    public static void awaitScenario(Workspace workspace) {
        Await.until("the scenario", () -> poll(workspace).isPresent());
    }

    /** Waits until the latest frame is that of a tick. */
    public static void awaitTick(Workspace workspace, long tick) {
        awaitFrame(workspace, "tick " + tick, frame -> frame.snapshot().tick() == tick);
    }

    /**
     * Waits until the latest frame meets a condition and the run has answered all commands. A frame that shows the
     * effect of a command is published before the answer, which changes the edited scenario and what can be undone.
     */
    public static void awaitFrame(Workspace workspace, String what, Predicate<SessionFrame> condition) {
        Await.until(what, () -> poll(workspace).filter(condition).isPresent() && !workspace.awaitsCommands());
    }
}
