package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ControllerSpecTest {

    private static Decision first(ControllerSpec spec) {
        return spec.create().decide(Observations.observation(0, Map.of()));
    }

    @Test
    void noneStaysWhereItIs() {
        assertEquals(new Decision(0, 0, Telemetry.ofState("NONE")), first(new ControllerSpec.None()));
    }

    @Test
    void driveDrives() {
        assertEquals(new Decision(2, -3, Telemetry.ofState("DRIVE")), first(new ControllerSpec.Drive(2, -3)));
    }

    @Test
    void aWallFollowerStartsBySearchingStraightAhead() {
        Decision decision = first(WallFollowing.DEFAULT);
        assertEquals("SEARCH", decision.telemetry().state());
        assertEquals(3, decision.leftVolts(), 1e-12, "0.3 m/s at 0.1 m/s per volt");
        assertEquals(3, decision.rightVolts(), 1e-12);
    }

    @Test
    void everyControllerStartsInTheStateThatItsSpecNames() {
        for (ControllerSpec spec :
                new ControllerSpec[] {new ControllerSpec.None(), new ControllerSpec.Drive(1, 1), WallFollowing.DEFAULT
                }) {
            assertEquals(spec.initialState(), first(spec).telemetry().state());
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -0.1, Double.NaN, Double.POSITIVE_INFINITY})
    void theDistanceMustBePositive(double distance) {
        Exception complaint = assertThrows(
                IllegalArgumentException.class, () -> new WallFollowing(distance, WallSide.LEFT, 0, TimingRule.RANGE));
        assertTrue(complaint.getMessage().contains("distance must be positive: " + distance), complaint.getMessage());
    }

    @ParameterizedTest
    @ValueSource(doubles = {-0.01, Double.NaN, Double.POSITIVE_INFINITY})
    void thePeriodMustNotBeNegative(double period) {
        Exception complaint = assertThrows(
                IllegalArgumentException.class, () -> new WallFollowing(0.25, WallSide.LEFT, period, TimingRule.RANGE));
        assertTrue(complaint.getMessage().contains("period must not be negative: " + period), complaint.getMessage());
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.NEGATIVE_INFINITY})
    void voltagesMustBeFinite(double volts) {
        assertThrows(IllegalArgumentException.class, () -> new Decision(volts, 0, Telemetry.ofState("TEST")));
        assertThrows(IllegalArgumentException.class, () -> new Decision(0, volts, Telemetry.ofState("TEST")));
    }
}
