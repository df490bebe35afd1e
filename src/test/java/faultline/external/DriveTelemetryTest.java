package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.Telemetry;
import faultline.robot.RobotSpec;
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

    @Test
    void aLongStateOrReasonIsCutAfter200Characters() throws ProtocolException {
        MessageReader message = MessageReader.of("{\"left_v\":1,\"right_v\":2,\"state\":\"" + "s".repeat(201)
                + "\",\"why\":\"" + "w".repeat(200) + "\"}");
        assertEquals(
                new DriveMessage(1, 2, "s".repeat(200), "w".repeat(200)),
                DriveMessage.read(message, RobotSpec.DEFAULT));
    }

    @Test
    void aCutTextEndsWithAWholeCharacter() throws ProtocolException {
        String why = "w".repeat(199);
        MessageReader message = MessageReader.of("{\"left_v\":1,\"right_v\":2,\"why\":\"" + why + "\ud83e\udd16\"}");
        assertEquals(why, DriveMessage.read(message, RobotSpec.DEFAULT).why());
    }

    private static Telemetry decide(DriveTelemetry states, String state, long tick) {
        return states.decide(new DriveMessage(0, 0, state, "why"), tick).telemetry();
    }
}
