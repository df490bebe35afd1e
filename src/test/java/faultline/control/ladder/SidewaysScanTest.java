package faultline.control.ladder;

import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerState;
import faultline.control.FollowerState;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.world.WorldSpec;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** With the left sensor alone, one scan shows enough of the path for a step along the wall. */
class SidewaysScanTest {

    @ParameterizedTest
    @CsvSource({"3.7,2.9", "4.3,3.1", "2.6,3.4", "5.2,2.2", "3.1,3.0"})
    void nearlyEveryScanIsFollowedByAStep(double width, double height) {
        RobotSpec robot = RobotSpec.DEFAULT.withSensors(RobotSpec.DEFAULT.sensors().stream()
                .map(sensor -> sensor.withOn(sensor.id().equals("left")))
                .toList());
        SimulationSetup setup = SimulationSetup.of(
                        new WorldSpec(width, height, true, 3, List.of()), new Pose(0.7, 0.6, 0.2))
                .withRobot(robot);
        int scans = 0;
        int steps = 0;
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            ControllerState before = FollowerState.SEARCH;
            Pose scanned = simulation.pose();
            while (simulation.time() < 240) {
                simulation.tick();
                ControllerState state = simulation.telemetry().state();
                if (state == FollowerState.MEASURE && before != state) {
                    Pose pose = simulation.pose();
                    scans++;
                    steps += Math.hypot(pose.x() - scanned.x(), pose.y() - scanned.y()) > 0.1 ? 1 : 0;
                    scanned = pose;
                }
                before = state;
            }
        }
        assertTrue(steps >= 0.8 * scans, steps + " steps after " + scans + " scans");
    }
}
