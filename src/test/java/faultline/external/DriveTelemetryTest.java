package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.Telemetry;
import org.junit.jupiter.api.Test;

/** The states of an external controller, as they are shown. */
class DriveTelemetryTest {

    @Test
    void aStateOfBlanksOnlyCountsAsMissing() {
        DriveTelemetry states = new DriveTelemetry("EXTERN");
        assertEquals("EXTERN", decide(states, " \t", 1).state().name());
        assertEquals("A", decide(states, "A", 2).state().name());
        Telemetry last = decide(states, "\n\0\ud83d", 3);
        assertEquals("A", last.state().name());
        assertEquals(2, last.sinceTick());
        assertEquals(1, last.transitions());
    }

    private static Telemetry decide(DriveTelemetry states, String state, long tick) {
        return states.decide(new DriveMessage(0, 0, state, "why"), tick).telemetry();
    }
}
