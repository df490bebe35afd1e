package faultline.control.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The local map holds large distances from a wall; if it cannot, the robot stops and gives the reason. */
class FarWallTest {

    private static final Vector2 CENTRE = new Vector2(8, 8);
    private static final double RADIUS = RobotSpec.DEFAULT.width() / 2;

    /** A closed wall, followed from inside, or a box, followed from outside, with sides along the axes. */
    private enum Place {
        ROOM(4, 3),
        BOX(2, 1.5);

        private final double halfLength;
        private final double halfWidth;

        Place(double halfLength, double halfWidth) {
            this.halfLength = halfLength;
            this.halfWidth = halfWidth;
        }

        WorldSpec world() {
            List<Vector2> corners = List.of(
                    new Vector2(-halfLength, -halfWidth),
                    new Vector2(halfLength, -halfWidth),
                    new Vector2(halfLength, halfWidth),
                    new Vector2(-halfLength, halfWidth),
                    new Vector2(-halfLength, -halfWidth));
            Obstacle obstacle =
                    new Obstacle("walls", new ObstacleShape.WallShape(corners), new Pose(CENTRE.x(), CENTRE.y(), 0));
            return new WorldSpec(16, 16, true, 3, List.of(obstacle));
        }

        /** Returns a place at a distance from the upper wall, which is on the robot's left. */
        Pose start(double distance, double turn) {
            return this == ROOM
                    ? new Pose(CENTRE.x(), CENTRE.y() + halfWidth - distance, turn)
                    : new Pose(CENTRE.x(), CENTRE.y() + halfWidth + distance, StrictMath.PI + turn);
        }

        double distance(Pose pose) {
            double x = Math.abs(pose.x() - CENTRE.x()) - halfLength;
            double y = Math.abs(pose.y() - CENTRE.y()) - halfWidth;
            return this == ROOM ? Math.min(-x, -y) : Math.hypot(Math.max(x, 0), Math.max(y, 0));
        }
    }

    /** Returns a run without the left sensor. */
    private static SimulationSetup setup(Place place, double wanted, double startDistance, double turn) {
        RobotSpec robot = RobotSpec.DEFAULT.withSensors(RobotSpec.DEFAULT.sensors().stream()
                .map(sensor -> sensor.withRange(3).withOn(!sensor.id().equals("left")))
                .toList());
        return SimulationSetup.of(place.world(), place.start(startDistance + RADIUS, turn))
                .withRobot(robot)
                .withController(WallFollowing.DEFAULT.withDistance(wanted));
    }

    /** The frame of the map is that of the first heading, so after a turn the walls are slanted in it. */
    @ParameterizedTest
    @CsvSource({
        "ROOM, 0.9, 0.9, 0",
        "ROOM, 0.9, 0.9, -22.5",
        "ROOM, 1.1, 1.1, 0",
        "ROOM, 1.1, 0.3, 0",
        "ROOM, 1.5, 1.5, -22.5",
        "ROOM, 1.9, 1.9, -22.5",
        "BOX, 0.9, 0.9, 0",
        "BOX, 1.9, 1.9, -22.5"
    })
    void itHoldsTheDistanceAlongAnyWallAndRoundCorners(Place place, double wanted, double startDistance, double turn) {
        int ticks = 0;
        int near = 0;
        SimulationSetup setup = setup(place, wanted, startDistance, Degrees.toRadians(turn));
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            while (simulation.time() < 45) {
                simulation.tick();
                if (simulation.time() > 15) {
                    ticks++;
                    double error = place.distance(simulation.pose()) - RADIUS - wanted;
                    near += Math.abs(error) < 0.1 ? 1 : 0;
                }
            }
            assertEquals("THREE", simulation.telemetry().diagnosis().rung());
            assertTrue(simulation.collision().isEmpty());
        }
        assertTrue(near > 0.9 * ticks, near + " of " + ticks);
    }

    @Test
    void beyondItsReachTheRobotStopsAndDrivesOnAtASmallerDistance() {
        SimulationSetup setup = setup(Place.ROOM, 1.95, 1.95, 0)
                .withTimeline(List.of(new TimedCommand(
                        5, new Command.ConfigureController(WallFollowing.DEFAULT.withDistance(1.85)))));
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            while (simulation.time() < 4) {
                simulation.tick();
            }
            assertEquals(
                    "the wanted distance is too large for the local map",
                    simulation.telemetry().condition());
            assertEquals(FaultTolerantFollower.STOP, simulation.telemetry().state());
            assertEquals("STOP", simulation.telemetry().diagnosis().rung());
            assertEquals(0, simulation.velocity().linear(), 1e-9);
            while (simulation.time() < 20) {
                simulation.tick();
            }
            assertNotEquals(FaultTolerantFollower.STOP, simulation.telemetry().state());
            assertTrue(simulation.pose().x() > CENTRE.x() + 1, simulation.pose()::toString);
        }
    }
}
