package faultline.gui.window;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.lang.reflect.InvocationTargetException;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The timer rests when nothing happens. Most tests poll in its place. */
class PollTimerTest {

    private final AtomicBoolean busy = new AtomicBoolean();
    private final PollTimer timer = new PollTimer(busy::get);

    @AfterEach
    void stop() {
        timer.stop();
    }

    private void poll(int times) {
        for (int i = 0; i < times; i++) {
            timer.poll();
        }
    }

    @Test
    void aSecondWithoutAChangeLeadsToRest() {
        poll(PollTimer.POLLS_BEFORE_REST - 1);
        assertFalse(timer.isResting());
        poll(1);
        assertTrue(timer.isResting());
        poll(1000);
        assertTrue(timer.isResting());
    }

    @Test
    void whatGoesOnPreventsRest() {
        busy.set(true);
        poll(1000);
        assertFalse(timer.isResting());
        busy.set(false);
        poll(PollTimer.POLLS_BEFORE_REST - 1);
        assertFalse(timer.isResting());
        poll(1);
        assertTrue(timer.isResting());
    }

    @Test
    void aChangeThatAPollFindsEndsTheRest() {
        poll(PollTimer.POLLS_BEFORE_REST);
        busy.set(true);
        poll(1);
        assertFalse(timer.isResting());
    }

    @Test
    void itPollsUntilItRestsAndAgainAfterASignal() throws InterruptedException, InvocationTargetException {
        EventQueue.invokeAndWait(() -> {
            timer.start();
            assertTrue(timer.isRunning());
            poll(PollTimer.POLLS_BEFORE_REST);
            assertFalse(timer.isRunning());
        });
        timer.signal();
        timer.signal();
        // The signal is handled before the next event.
        EventQueue.invokeAndWait(() -> assertTrue(timer.isRunning()));
    }

    @Test
    void aSignalDoesNotStartAStoppedTimer() throws InterruptedException, InvocationTargetException {
        timer.signal();
        EventQueue.invokeAndWait(() -> assertFalse(timer.isRunning()));
    }

    @Test
    void anEventOfTheUserEndsTheRest() {
        poll(PollTimer.POLLS_BEFORE_REST);
        timer.wake();
        assertFalse(timer.isResting());
        poll(PollTimer.POLLS_BEFORE_REST);
        assertTrue(timer.isResting());
    }
}
