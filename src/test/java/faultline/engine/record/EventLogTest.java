package faultline.engine.record;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** The event log: its order, its bound, and finding a moment in it. */
class EventLogTest {

    private final EventRecorder recorder = new EventRecorder();

    private EventLog after(int events) {
        for (int i = 0; i < events; i++) {
            recorder.add(new RunEvent.Transition(10L * i, i, "A", "B", "go"));
        }
        return recorder.view();
    }

    @Test
    void eventsKeepTheirOrder() {
        EventLog log = after(3);
        assertEquals(0, log.first());
        assertEquals(3, log.end());
        assertEquals(20, log.get(2).tick());
        assertThrows(IndexOutOfBoundsException.class, () -> log.get(3));
    }

    @Test
    void theOldestAreForgottenAndTheNewestKeepTheirNumbers() {
        EventLog log = after(100_000);
        assertEquals(100_000, log.end());
        assertTrue(log.end() - log.first() <= 8192 && log.end() - log.first() >= 7680, "kept: " + (log.end() - log.first()));
        assertEquals(999_990, log.get(99_999).tick());
        assertEquals(10 * log.first(), log.get(log.first()).tick());
        assertThrows(IndexOutOfBoundsException.class, () -> log.get(log.first() - 1));
    }

    @Test
    void aViewStaysAsItIsWhileTheLogGoesOn() {
        EventLog early = after(600);
        after(50_000);
        assertEquals(600, early.end());
        assertEquals(5990, early.get(599).tick());
    }

    @Test
    void aMomentIsFoundByItsTick() {
        EventLog log = after(100);
        assertEquals(0, log.since(0));
        assertEquals(5, log.since(50));
        assertEquals(6, log.since(51));
        assertEquals(100, log.since(991));
    }
}
