package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
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
}
