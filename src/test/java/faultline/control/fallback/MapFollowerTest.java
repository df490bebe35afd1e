package faultline.control.fallback;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.robot.DriveScale;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The distance that the local map keeps after the left sensor has failed. */
class MapFollowerTest {

    private static final double LENGTH = 12;
    private static final double WIDTH = 9;

    private static final TimedCommand LEFT_FAILS =
            new TimedCommand(30, new Command.InjectFault("left", new Fault.Dead()));

    private static SimulationSetup room(List<Obstacle> obstacles, Pose start) {
        return SimulationSetup.of(new WorldSpec(LENGTH, WIDTH, true, 3, obstacles), start);
    }

    /** Returns the distance from the centre to the nearest wall of an empty room. */
    private static double toWall(Pose pose) {
        return Math.min(Math.min(pose.x(), LENGTH - pose.x()), Math.min(pose.y(), WIDTH - pose.y()));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.25, 0.4, 0.5, 0.6, 0.75})
    void theDistanceIsKeptAlongWallsAndInCorners(double wanted) {
        SimulationSetup setup = room(List.of(), new Pose(6, 4.5, 0))
                .withController(WallFollowing.DEFAULT.withDistance(wanted))
                .withTimeline(List.of(LEFT_FAILS));
        int ticks = 0;
        int near = 0;
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            while (simulation.time() < 90) {
                simulation.tick();
                if (simulation.time() > 45) {
                    ticks++;
                    double error = toWall(simulation.pose()) - RobotSpec.DEFAULT.width() / 2 - wanted;
                    near += Math.abs(error) < 0.1 ? 1 : 0;
                }
            }
            assertEquals("THREE", simulation.telemetry().diagnosis().rung());
        }
        assertTrue(near > 0.95 * ticks, near + " of " + ticks);
    }

    @Test
    void aDistanceThatIsChangedOnTheLocalMapIsReached() {
        SimulationSetup setup = room(List.of(), new Pose(6, 4.5, 0))
                .withTimeline(List.of(
                        LEFT_FAILS,
                        new TimedCommand(
                                40, new Command.ConfigureController(WallFollowing.DEFAULT.withDistance(0.6)))));
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            while (simulation.time() < 55) {
                simulation.tick();
            }
            assertEquals(0.7, toWall(simulation.pose()), 0.1);
        }
    }

    /** The box leaves passages of 1 m, of which the wanted distance and half the robot take more than half. */
    @ParameterizedTest
    @CsvSource({"left, 0.5", "front, 0.5", "left, 0.55", "front, 0.55"})
    void aPassageIsPassedAlongTheWallThatIsFollowed(String sensor, double wanted) {
        Obstacle box = new Obstacle("box", new ObstacleShape.RectangleShape(2, WIDTH - 2), new Pose(6, WIDTH / 2, 0));
        SimulationSetup setup = room(List.of(box), new Pose(3, 4.5, StrictMath.toRadians(200)))
                .withController(WallFollowing.DEFAULT.withDistance(wanted))
                .withTimeline(List.of(new TimedCommand(10, new Command.InjectFault(sensor, new Fault.Dead()))));
        StringBuilder passed = new StringBuilder("w");
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            while (simulation.time() < 240 && simulation.collision().isEmpty()) {
                simulation.tick();
                char place = place(simulation.pose());
                if (passed.charAt(passed.length() - 1) != place) {
                    passed.append(place);
                }
            }
            assertTrue(simulation.collision().isEmpty(), () -> "at " + simulation.time() + " s");
        }
        assertTrue(passed.indexOf("wne") >= 0 || passed.indexOf("wse") >= 0, passed::toString);
    }

    /** Returns the part of the room: north and south of the box, or west and east of it. */
    private static char place(Pose pose) {
        if (Math.abs(pose.x() - 6) <= 1) {
            return pose.y() > WIDTH / 2 ? 'n' : 's';
        }
        return pose.x() < 6 ? 'w' : 'e';
    }

    /** The corners of the default robot are 0.16 m from its centre, which this distance keeps 0.2 m from the wall. */
    @ParameterizedTest
    @ValueSource(strings = {"left", "front"})
    void aRobotNearItsWallKeepsAMarginAfterAFault(String sensor) {
        Obstacle pole = new Obstacle("pole", new ObstacleShape.CircleShape(0.04), new Pose(4, 0.5, 0));
        SimulationSetup setup = room(List.of(pole), new Pose(6, 4.5, 0))
                .withController(WallFollowing.DEFAULT.withDistance(0.1))
                .withTimeline(List.of(new TimedCommand(30, new Command.InjectFault(sensor, new Fault.Dead()))));
        double nearest = Double.POSITIVE_INFINITY;
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            while (simulation.time() < 120 && simulation.collision().isEmpty()) {
                simulation.tick();
                if (simulation.time() > 45) {
                    nearest = Math.min(nearest, toWall(simulation.pose()));
                }
            }
            assertTrue(simulation.collision().isEmpty(), () -> "at " + simulation.time() + " s");
        }
        assertEquals(0.25, nearest, 0.04);
    }

    /** The corners of this robot are 0.47 m from its centre, which the default distance keeps 0.5 m from the wall. */
    @Test
    void aLongRobotKeepsTheRoomThatItNeedsToTurn() {
        RobotSpec robot = new RobotSpec(
                0.8,
                0.5,
                0.45,
                0.3,
                StrictMath.toRadians(60),
                MotorSpec.DEFAULT,
                DriveScale.NONE,
                RobotSpec.standardSensors(0.8, 0.5));
        Obstacle box = new Obstacle("box", new ObstacleShape.RectangleShape(1.5, 1.5), new Pose(2.5, 5.5, 0.5));
        for (int degrees = 0; degrees < 360; degrees += 40) {
            SimulationSetup setup = room(List.of(box), new Pose(6, 3, StrictMath.toRadians(degrees)))
                    .withRobot(robot)
                    .withTimeline(List.of(LEFT_FAILS));
            try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
                while (simulation.time() < 120 && simulation.collision().isEmpty()) {
                    simulation.tick();
                }
                int start = degrees;
                assertTrue(simulation.collision().isEmpty(), () -> start + " degrees: " + simulation.time() + " s");
            }
        }
    }
}
