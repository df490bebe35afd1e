package faultline.control;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ControllerSpecTest {

    @ParameterizedTest
    @ValueSource(doubles = {0, -0.1, Double.NaN, Double.POSITIVE_INFINITY})
    void theDistanceMustBePositive(double distance) {
        Exception problem =
                assertThrows(IllegalArgumentException.class, () -> WallFollowing.DEFAULT.withDistance(distance));
        assertTrue(problem.getMessage().contains("distance must be positive: " + distance), problem.getMessage());
    }

    @ParameterizedTest
    @ValueSource(doubles = {-0.01, Double.NaN, Double.POSITIVE_INFINITY})
    void thePeriodMustNotBeNegative(double period) {
        Exception problem =
                assertThrows(IllegalArgumentException.class, () -> WallFollowing.DEFAULT.withPeriod(period));
        assertTrue(problem.getMessage().contains("period must not be negative: " + period), problem.getMessage());
        assertThrows(IllegalArgumentException.class, () -> new ControllerSpec.Extern(period));
        assertThrows(IllegalArgumentException.class, () -> new ControllerSpec.Provided("example", period, Map.of()));
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.NEGATIVE_INFINITY})
    void voltagesMustBeFinite(double volts) {
        assertThrows(
                IllegalArgumentException.class,
                () -> new Decision(volts, 0, Telemetry.ofState(ControllerState.of("TEST"))));
        assertThrows(
                IllegalArgumentException.class,
                () -> new Decision(0, volts, Telemetry.ofState(ControllerState.of("TEST"))));
        assertThrows(IllegalArgumentException.class, () -> new ControllerSpec.Drive(volts, 0));
        assertThrows(IllegalArgumentException.class, () -> new ControllerSpec.Drive(0, volts));
    }
}
