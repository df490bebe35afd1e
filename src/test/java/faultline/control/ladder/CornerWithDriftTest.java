package faultline.control.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.SensorFinding;
import faultline.control.SensorHealth;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.robot.DriveScale;
import faultline.robot.RobotSpec;
import faultline.sensor.FaultKind;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** After the turn in a corner, the wall beside the robot shows what the front sensor measured of it. */
class CornerWithDriftTest {

    private static final Pose START = new Pose(1, 2.6, 0.02);

    private static Simulation room(RobotSpec robot, List<Obstacle> obstacles, List<TimedCommand> timeline) {
        SimulationSetup setup = new SimulationSetup(
                new WorldSpec(4, 3, true, 3, obstacles),
                robot,
                START,
                ControllerSpec.WallFollowing.DEFAULT,
                timeline,
                0.01,
                1,
                120);
        return new Simulation(setup, ControllerMode.DIRECT);
    }

    private static List<SensorHealth> distrusted(Simulation simulation) {
        return simulation.telemetry().diagnosis().health().stream()
                .filter(health -> !health.isTrusted())
                .toList();
    }

    private static Simulation untilDistrusted(List<TimedCommand> timeline, double until) {
        Simulation simulation = room(RobotSpec.DEFAULT, List.of(), timeline);
        while (distrusted(simulation).isEmpty()) {
            simulation.tick();
            assertTrue(simulation.time() < until, "not found");
        }
        assertEquals(
                List.of("front"),
                distrusted(simulation).stream().map(SensorHealth::sensor).toList());
        return simulation;
    }

    /** The errors are less than those that the map finds. */
    @ParameterizedTest
    @CsvSource({"0.04", "-0.04", "0.05", "-0.05"})
    void aSmallBiasIsFoundInTheFirstCorner(double bias) {
        Simulation simulation = untilDistrusted(
                List.of(new TimedCommand(2, new Command.InjectFault("front", FaultKind.BIAS.createFault(bias)))), 20);
        assertEquals(SensorFinding.INCONSISTENT, distrusted(simulation).get(0).finding());
    }

    @ParameterizedTest
    @CsvSource({"0.003", "-0.003", "0.005", "-0.005"})
    void driftIsFoundBeforeItsErrorIs8Centimetres(double rate) {
        Simulation simulation = untilDistrusted(
                List.of(new TimedCommand(2, new Command.InjectFault("front", FaultKind.DRIFT.createFault(rate)))), 40);
        assertTrue(Math.abs(rate) * (simulation.time() - 2) < 0.08, "found at " + simulation.time());
    }

    /** A surface that ends between two cones is looked at for a moment, as if the front sensor had missed it. */
    private static void assertFrontIsTrusted(RobotSpec robot, List<Obstacle> obstacles) {
        Simulation simulation = room(robot, obstacles, List.of());
        while (simulation.time() < 60) {
            simulation.tick();
            assertTrue(
                    distrusted(simulation).stream()
                            .noneMatch(health ->
                                    health.sensor().equals("front") && health.finding() != SensorFinding.BLIND),
                    () -> distrusted(simulation) + " at " + simulation.time() + " with " + obstacles);
        }
    }

    private static Obstacle box(double x, double y, double heading, double length, double width) {
        return new Obstacle("box", new ObstacleShape.RectangleShape(length, width), new Pose(x, y, heading));
    }

    @Test
    void aSlantedWallAccusesNoOne() {
        for (double degrees : new double[] {-35, -20, 15, 30}) {
            assertFrontIsTrusted(RobotSpec.DEFAULT, List.of(box(4, 2, Math.toRadians(degrees), 0.6, 4)));
        }
    }

    @Test
    void aStepOfTheWallAheadAccusesNoOne() {
        for (double step : new double[] {0.05, 0.1, 0.2}) {
            for (double bottom : new double[] {2.2, 2.5, 2.7}) {
                assertFrontIsTrusted(RobotSpec.DEFAULT, List.of(box(4, bottom + 0.5, 0, 2 * step, 1)));
                assertFrontIsTrusted(RobotSpec.DEFAULT, List.of(box(4, bottom - 1.5, 0, 2 * step, 3)));
            }
        }
    }

    @Test
    void aPostAheadAccusesNoOne() {
        for (double y : new double[] {2.45, 2.6, 2.7}) {
            Obstacle post = new Obstacle("post", new ObstacleShape.CircleShape(0.03), new Pose(3.7, y, 0));
            assertFrontIsTrusted(RobotSpec.DEFAULT, List.of(post));
        }
    }

    @ParameterizedTest
    @CsvSource({"0.95, 1.05, 1", "1.05, 0.95, 1", "1.05, 1.05, 1.05", "0.95, 0.95, 0.95"})
    void withWheelsThatDifferTheFrontSensorIsTrusted(double left, double right, double track) {
        assertFrontIsTrusted(RobotSpec.DEFAULT.withDriveScale(new DriveScale(left, right, track)), List.of());
    }
}
