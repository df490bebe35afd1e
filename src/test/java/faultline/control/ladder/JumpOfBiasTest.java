package faultline.control.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.SensorHealth;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.sensor.FaultKind;
import faultline.world.Command;
import faultline.world.WorldSpec;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A bias that sets in while the robot follows a long straight wall is found soon, and in the sensor that has it. */
class JumpOfBiasTest {

    @ParameterizedTest
    @CsvSource({
        "front-left, 0.12",
        "front-left, 0.2",
        "front-left, -0.1",
        "rear-left, 0.12",
        "rear-left, 0.2",
        "rear-left, -0.1"
    })
    void isFoundWithinTwoSeconds(String sensor, double bias) {
        for (double onset = 12; onset <= 16; onset++) {
            assertFoundWithin(2, sensor, bias, onset);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.06, 0.08, 0.1, 0.12, 0.15, 0.2, 0.3, -0.06, -0.1, -0.15})
    void ofTheSensorThatFacesTheWallIsFoundWithinAThirdOfASecond(double bias) {
        for (double onset = 12; onset <= 16; onset += 0.25) {
            assertFoundWithin(0.33, "left", bias, onset);
        }
    }

    private static void assertFoundWithin(double seconds, String sensor, double bias, double onset) {
        SimulationSetup setup = new SimulationSetup(
                new WorldSpec(9, 4, true, 3, List.of()),
                RobotSpec.DEFAULT,
                new Pose(1, 3.6, 0.02),
                ControllerSpec.WallFollowing.DEFAULT,
                List.of(new TimedCommand(onset, new Command.InjectFault(sensor, FaultKind.BIAS.createFault(bias)))),
                0.01,
                1,
                60);
        Simulation simulation = new Simulation(setup, ControllerMode.DIRECT);
        List<String> distrusted = List.of();
        while (distrusted.isEmpty()) {
            simulation.tick();
            assertTrue(simulation.time() < onset + seconds, "not found in time at " + onset);
            distrusted = simulation.telemetry().diagnosis().health().stream()
                    .filter(health -> !health.isTrusted())
                    .map(SensorHealth::sensor)
                    .toList();
        }
        assertEquals(List.of(sensor), distrusted);
        assertTrue(simulation.time() > onset);
    }
}
