package faultline.gui.window;

import java.awt.AWTEvent;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import javax.swing.Timer;

/**
 * Polls about sixty times per second while something happens, and stops when nothing has happened for a second, so that
 * a paused window takes no processor time. Any event of the user or a {@link #signal()} starts it again. All methods
 * except {@code signal} must be called on the event dispatch thread.
 */
final class PollTimer {

    static final int MILLIS = 16;
    /**
     * The number of polls without a change after which the timer rests; enough for values that are updated
     * occasionally.
     */
    static final int POLLS_BEFORE_REST = 60;

    private static final long USER_EVENTS = AWTEvent.KEY_EVENT_MASK
            | AWTEvent.MOUSE_EVENT_MASK
            | AWTEvent.MOUSE_MOTION_EVENT_MASK
            | AWTEvent.MOUSE_WHEEL_EVENT_MASK
            | AWTEvent.FOCUS_EVENT_MASK
            | AWTEvent.WINDOW_EVENT_MASK;

    private final BooleanSupplier poll;
    private final Timer timer = new Timer(MILLIS, event -> poll());
    private final AWTEventListener waker = event -> wake();
    private final AtomicBoolean signalled = new AtomicBoolean();
    private boolean started;
    private int quietPolls;

    /** Creates a stopped timer; {@code poll} returns whether something has changed or is in progress. */
    PollTimer(BooleanSupplier poll) {
        this.poll = poll;
        timer.setInitialDelay(0);
    }

    void start() {
        Toolkit.getDefaultToolkit().addAWTEventListener(waker, USER_EVENTS);
        started = true;
        wake();
    }

    void stop() {
        started = false;
        timer.stop();
        Toolkit.getDefaultToolkit().removeAWTEventListener(waker);
    }

    /** Polls once. */
    void poll() {
        quietPolls = poll.getAsBoolean() ? 0 : quietPolls + 1;
        if (isResting()) {
            timer.stop();
        }
    }

    /** Wakes the timer soon; any thread may call this. */
    void signal() {
        if (!signalled.getAndSet(true)) {
            EventQueue.invokeLater(() -> {
                signalled.set(false);
                wake();
            });
        }
    }

    /** Polls from now on, until nothing has happened for a second. */
    void wake() {
        quietPolls = 0;
        if (started && !timer.isRunning()) {
            timer.start();
        }
    }

    /** Returns whether nothing has happened for a second. */
    boolean isResting() {
        return quietPolls >= POLLS_BEFORE_REST;
    }

    boolean isRunning() {
        return timer.isRunning();
    }
}
