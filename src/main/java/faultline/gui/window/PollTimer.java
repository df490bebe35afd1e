package faultline.gui.window;

import java.awt.AWTEvent;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.util.function.BooleanSupplier;
import javax.swing.Timer;

/**
 * Polls about sixty times per second while something happens, and twice per second when nothing has happened for a
 * second, so that a paused window takes no processor time. Any event of the user restores the higher rate at once.
 */
final class PollTimer {

    static final int BUSY_MILLIS = 16;
    static final int RESTING_MILLIS = 500;
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
    private final Timer timer = new Timer(BUSY_MILLIS, event -> poll());
    private final AWTEventListener waker = event -> wake();
    private int quietPolls;

    /** Creates a stopped timer; {@code poll} returns whether something has changed or is in progress. */
    PollTimer(BooleanSupplier poll) {
        this.poll = poll;
        timer.setInitialDelay(0);
    }

    void start() {
        Toolkit.getDefaultToolkit().addAWTEventListener(waker, USER_EVENTS);
        timer.start();
    }

    void stop() {
        timer.stop();
        Toolkit.getDefaultToolkit().removeAWTEventListener(waker);
    }

    /** Polls once. */
    void poll() {
        quietPolls = poll.getAsBoolean() ? 0 : quietPolls + 1;
        if (quietPolls == POLLS_BEFORE_REST) {
            timer.setDelay(RESTING_MILLIS);
        } else if (quietPolls == 0 && isResting()) {
            wake();
        }
    }

    /** Switches to frequent polling. */
    void wake() {
        quietPolls = 0;
        if (isResting()) {
            timer.setDelay(BUSY_MILLIS);
            if (timer.isRunning()) {
                timer.restart();
            }
        }
    }

    boolean isResting() {
        return timer.getDelay() == RESTING_MILLIS;
    }
}
