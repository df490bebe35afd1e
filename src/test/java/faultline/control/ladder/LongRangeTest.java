package faultline.control.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.world.WorldSpec;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Healthy sensors that see farther than the map of the diagnosis reaches stay trusted. */
class LongRangeTest {

    @ParameterizedTest
    @ValueSource(doubles = {1.6, 2, 3, 5, 100})
    void sensorsOfALongRangeStayTrusted(double range) {
        RobotSpec robot = RobotSpec.DEFAULT.withSensors(RobotSpec.DEFAULT.sensors().stream()
                .map(sensor -> sensor.withRange(range))
                .toList());
        Simulation simulation = new Simulation(
                SimulationSetup.of(new WorldSpec(6, 4, true, 3, List.of()), new Pose(1.2, 3, 0))
                        .withRobot(robot),
                ControllerMode.DIRECT);
        while (simulation.time() < 60) {
            simulation.tick();
            assertEquals(
                    "ALL",
                    simulation.telemetry().diagnosis().rung(),
                    () -> simulation.time() + " s: "
                            + simulation.telemetry().diagnosis().health());
        }
        assertTrue(simulation.collision().isEmpty());
    }
}
