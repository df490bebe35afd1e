package faultline.control.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.FollowerState;
import faultline.control.Telemetry.WallControl;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The local map shows the distances that it steers by. */
class MapDistanceTest {

    private static final double WIDTH = 3.7;
    private static final double HEIGHT = 2.9;

    @ParameterizedTest
    @ValueSource(strings = {"front-left left rear-left", "front-left", "rear-left rear"})
    void itsDistancesAreThoseOfTheRoom(String on) {
        Set<String> sensors = Set.of(on.split(" "));
        RobotSpec robot = RobotSpec.DEFAULT.withSensors(RobotSpec.DEFAULT.sensors().stream()
                .map(sensor -> sensor.withOn(sensors.contains(sensor.id())))
                .toList());
        SimulationSetup setup = SimulationSetup.of(
                        new WorldSpec(WIDTH, HEIGHT, true, 3, List.of()), new Pose(0.7, 0.6, 0.2))
                .withRobot(robot)
                .withController(WallFollowing.DEFAULT.withDistance(0.28));
        int shown = 0;
        int near = 0;
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            while (simulation.time() < 60) {
                simulation.tick();
                WallControl wall = simulation.telemetry().wall();
                if (simulation.telemetry().state() == FollowerState.FOLLOW && wall.measuredDistance() > 0) {
                    assertEquals(0.28, wall.wantedDistance());
                    shown++;
                    near += Math.abs(wall.measuredDistance() - trueDistance(simulation.pose())) < 0.08 ? 1 : 0;
                }
            }
        }
        assertTrue(shown > 1500, "shown in " + shown + " ticks");
        assertTrue(near > 0.85 * shown, near + " of " + shown);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.04, 0.1})
    void itHoldsTheDistanceAtTheSensorThatFacesTheWall(double mountY) {
        RobotSpec robot = RobotSpec.DEFAULT.withSensors(RobotSpec.DEFAULT.sensors().stream()
                .map(sensor ->
                        sensor.withOn(Set.of("front-left", "left", "rear-left").contains(sensor.id())))
                .map(sensor -> sensor.id().equals("left") ? sensor.withMountPosition(new Vector2(0, mountY)) : sensor)
                .toList());
        SimulationSetup setup = SimulationSetup.of(
                        new WorldSpec(WIDTH, HEIGHT, true, 3, List.of()), new Pose(0.7, 0.6, 0.2))
                .withRobot(robot)
                .withController(WallFollowing.DEFAULT.withDistance(0.28));
        RunResult result = HeadlessRun.run(setup, ControllerMode.DIRECT, List.of());
        assertEquals("THREE", result.rung());
        assertEquals(0, result.distanceRms().orElseThrow(), 0.05);
        assertTrue(result.coverage().orElseThrow() > 0.8, result.coverage()::toString);
    }

    private static double trueDistance(Pose pose) {
        double x = Math.min(pose.x(), WIDTH - pose.x());
        double y = Math.min(pose.y(), HEIGHT - pose.y());
        return Math.min(x, y) - RobotSpec.DEFAULT.width() / 2;
    }
}
