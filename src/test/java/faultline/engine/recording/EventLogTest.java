package faultline.engine.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.FollowerState;
import org.junit.jupiter.api.Test;

/** The event log: its order, its bound, and finding a moment in it. */
class EventLogTest {

    private final EventRecorder recorder = new EventRecorder();

    private EventLog logOf(int events) {
        for (int i = 0; i < events; i++) {
            recorder.add(new RunEvent.StateChanged(10L * i, i, FollowerState.SEARCH, FollowerState.TURN, "go"));
        }
        return recorder.view();
    }

    @Test
    void eventsKeepTheirOrder() {
        EventLog log = logOf(3);
        assertEquals(0, log.firstIndex());
        assertEquals(3, log.endIndex());
        assertEquals(20, log.get(2).tick());
        assertThrows(IndexOutOfBoundsException.class, () -> log.get(3));
    }

    @Test
    void theOldestAreForgottenAndTheNewestKeepTheirNumbers() {
        EventLog log = logOf(100_000);
        assertEquals(100_000, log.endIndex());
        assertTrue(
                log.endIndex() - log.firstIndex() <= 8192 && log.endIndex() - log.firstIndex() >= 7680,
                "kept: " + (log.endIndex() - log.firstIndex()));
        assertEquals(999_990, log.get(99_999).tick());
        assertEquals(10 * log.firstIndex(), log.get(log.firstIndex()).tick());
        assertThrows(IndexOutOfBoundsException.class, () -> log.get(log.firstIndex() - 1));
    }

    @Test
    void aViewStaysAsItIsWhileTheLogGoesOn() {
        EventLog early = logOf(600);
        logOf(50_000);
        assertEquals(600, early.endIndex());
        assertEquals(5990, early.get(599).tick());
    }

    @Test
    void aMomentIsFoundByItsTick() {
        EventLog log = logOf(100);
        assertEquals(0, log.firstIndexSince(0));
        assertEquals(5, log.firstIndexSince(50));
        assertEquals(6, log.firstIndexSince(51));
        assertEquals(100, log.firstIndexSince(991));
    }
}
