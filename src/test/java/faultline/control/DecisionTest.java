package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DecisionTest {

    private static final Telemetry WAIT = Telemetry.ofState(ControllerState.of("WAIT"));

    @ParameterizedTest
    @CsvSource({"NaN, 0", "0, NaN", "Infinity, 0", "0, -Infinity"})
    void aVoltageThatIsNotFiniteIsRefused(double left, double right) {
        IllegalArgumentException refusal =
                assertThrows(IllegalArgumentException.class, () -> new Decision(left, right, WAIT));
        assertEquals("voltages must be finite: " + left + ", " + right, refusal.getMessage());
    }

    /** Otherwise the run would break after the controller, with a message that does not name it. */
    @Test
    void aDecisionWithoutTelemetryIsRefused() {
        NullPointerException refusal = assertThrows(NullPointerException.class, () -> new Decision(0, 0, null));
        assertEquals("a decision needs telemetry", refusal.getMessage());
    }

    @Test
    void aPartThatIsNullIsNamed() {
        Velocity still = new Velocity(0, 0);
        assertRefused("the robot of the decision is null", () -> Decision.ofVelocity(null, still, "WAIT", ""));
        assertRefused(
                "the velocity of the decision is null", () -> Decision.ofVelocity(RobotSpec.DEFAULT, null, "WAIT", ""));
        assertRefused(
                "the state of the decision is null", () -> Decision.ofVelocity(RobotSpec.DEFAULT, still, null, ""));
        assertRefused(
                "the why of the decision is null; it may be empty",
                () -> Decision.ofVelocity(RobotSpec.DEFAULT, still, "WAIT", null));
    }

    private static void assertRefused(String sentence, Executable creation) {
        assertEquals(
                sentence, assertThrows(NullPointerException.class, creation).getMessage());
    }
}
