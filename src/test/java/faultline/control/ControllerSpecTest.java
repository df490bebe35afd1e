package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.diagnosis.SensorDiagnosis;
import faultline.control.fallback.MapFollower;
import faultline.control.ladder.FaultTolerantFollower;
import faultline.control.wallfollower.WallFollower;
import faultline.robot.DriveScale;
import faultline.robot.RobotSpec;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ControllerSpecTest {

    @ParameterizedTest
    @ValueSource(doubles = {0, -0.1, Double.NaN, Double.POSITIVE_INFINITY})
    void theDistanceMustBePositive(double distance) {
        Exception problem =
                assertThrows(IllegalArgumentException.class, () -> WallFollowing.DEFAULT.withDistance(distance));
        assertTrue(problem.getMessage().contains("distance must be positive: " + distance), problem.getMessage());
        assertThrows(IllegalArgumentException.class, () -> new ControllerSpec.Extern(0, distance));
        assertThrows(
                IllegalArgumentException.class, () -> new ControllerSpec.Provided("example", 0, distance, Map.of()));
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

    @ParameterizedTest
    @CsvSource({
        "0, 1, 10, a tick must be positive: 0.0",
        "NaN, 1, 10, a tick must be positive: NaN",
        "Infinity, 1, 10, a tick must be positive: Infinity",
        "0.01, 0, 10, a decision must hold for at least one tick: 0",
        "0.01, 1, -1, the duration must not be negative: -1.0",
        "0.01, 1, NaN, the duration must not be negative: NaN",
        "0.01, 1, Infinity, the duration must not be negative: Infinity"
    })
    void theConditionsOfARunAreChecked(double dt, long periodTicks, double duration, String message) {
        Executable create = () -> new ControllerSource.RunConditions(1, dt, periodTicks, duration, RobotSpec.DEFAULT);
        assertEquals(
                message, assertThrows(IllegalArgumentException.class, create).getMessage());
    }

    @Test
    void theConditionsOfARunHaveNoTrueDrive() {
        RobotSpec wide = RobotSpec.DEFAULT.withDriveScale(new DriveScale(1, 1, 1.05));
        assertThrows(IllegalArgumentException.class, () -> new ControllerSource.RunConditions(1, 0.01, 1, 0, wide));
        assertEquals(0, new ControllerSource.RunConditions(1, 0.01, 1, 0, wide.believed()).duration());
    }

    @Test
    void aRunningFollowerRefusesSettingsWithWhichItCannotContinue() {
        WallFollowing spec = WallFollowing.DEFAULT;
        MapFollower mapFollower = new MapFollower(new SensorDiagnosis(spec.side()), spec);
        Controller sixStates = new WallFollower(spec);
        Controller tolerant = new FaultTolerantFollower(spec);
        for (WallFollowing other :
                List.of(spec.withSide(WallSide.RIGHT), spec.withPeriod(0.05), spec.withDiagnosis(!spec.diagnosis()))) {
            assertThrows(IllegalArgumentException.class, () -> mapFollower.configure(other));
            assertThrows(IllegalArgumentException.class, () -> sixStates.configure(other));
            assertThrows(IllegalArgumentException.class, () -> tolerant.configure(other));
        }
        assertThrows(IllegalArgumentException.class, () -> sixStates.configure(new ControllerSpec.None()));
        WallFollowing farther = spec.withDistance(0.4);
        mapFollower.configure(farther);
        sixStates.configure(farther);
        tolerant.configure(farther);
        assertSame(farther, spec.changedTo(farther));
    }
}
