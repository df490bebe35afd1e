package faultline.control.ladder;

import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.SensorHealth;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * Poles, boxes and gaps at a wall make the readings of healthy sensors jump. The sensor that faces the wall is not
 * distrusted for that, and the robot touches nothing.
 */
class ThingsAtAWallTest {

    private static final int ROOMS = 100;
    private static final double LENGTH = 13;
    private static final double WALL = 4;

    @Test
    void theSensorThatFacesTheWallStaysTrusted() {
        for (int room = 0; room < ROOMS; room++) {
            Simulation simulation = new Simulation(
                    new SimulationSetup(
                            new WorldSpec(LENGTH, WALL, true, 3, things(new Random(9000 + room))),
                            RobotSpec.DEFAULT,
                            new Pose(1, WALL - 0.4, 0.02),
                            ControllerSpec.WallFollowing.DEFAULT,
                            List.of(),
                            0.01,
                            1,
                            60),
                    ControllerMode.DIRECT);
            while (simulation.time() < 60) {
                simulation.tick();
                assertTrue(isTrusted(simulation, "left"), "room " + room + " at " + simulation.time());
                assertTrue(simulation.collision().isEmpty(), "room " + room + " at " + simulation.time());
            }
        }
    }

    private static boolean isTrusted(Simulation simulation, String sensor) {
        return simulation.telemetry().diagnosis().health().stream()
                .filter(health -> health.sensor().equals(sensor))
                .allMatch(SensorHealth::isTrusted);
    }

    /** Returns poles near the wall, boxes at it, and pairs of boxes with a gap of 10 to 45 cm between them. */
    private static List<Obstacle> things(Random random) {
        List<Obstacle> things = new ArrayList<>();
        double x = 2.5;
        while (x < LENGTH - 2) {
            switch (random.nextInt(3)) {
                case 0 -> {
                    double radius = 0.005 + 0.08 * random.nextDouble();
                    double y = WALL - radius - 0.05 * random.nextDouble();
                    things.add(new Obstacle("pole-" + x, new ObstacleShape.CircleShape(radius), new Pose(x, y, 0)));
                    x += radius + 0.4;
                }
                case 1 ->
                    x = addBox(things, x, 0.1 + 0.8 * random.nextDouble(), 0.03 + 0.15 * random.nextDouble()) + 0.5;
                default -> {
                    double depth = 0.05 + 0.25 * random.nextDouble();
                    double gap = 0.1 + 0.35 * random.nextDouble();
                    x = addBox(things, x, 0.5 + 0.5 * random.nextDouble(), depth) + gap;
                    x = addBox(things, x, 0.5 + 0.5 * random.nextDouble(), depth) + 0.5;
                }
            }
            x += 1.2 * random.nextDouble();
        }
        return things;
    }

    /** Adds a box that protrudes from the wall, and returns where it ends. */
    private static double addBox(List<Obstacle> things, double x, double width, double depth) {
        things.add(new Obstacle(
                "box-" + x, new ObstacleShape.RectangleShape(width, 2 * depth), new Pose(x + width / 2, WALL, 0)));
        return x + width;
    }
}
