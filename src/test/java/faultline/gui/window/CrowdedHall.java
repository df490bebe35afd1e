package faultline.gui.window;

import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.theme.Theme;
import faultline.robot.RobotSpec;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import faultline.world.WorldSpec;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** A hall full of shapes of every kind, with an aisle along the wall that the robot circles. */
final class CrowdedHall {

    /** The number of shapes in the hall. */
    static final int SHAPES = 500;

    /** The number of moving shapes. */
    static final int MOVING = 3;

    private static final int COLUMNS = 28;
    private static final double PITCH = 0.36;
    private static final double AISLE = 1.1;

    private final Random random = new Random(7);

    private CrowdedHall() {}

    /** Opens a window with the hall, stored in a file of a folder. */
    static WindowDriver open(Path folder) throws IOException, ScenarioException {
        Path file = folder.resolve("hall.xml");
        scenario().save(file);
        return WindowDriver.open(Theme.LIGHT, file);
    }

    static Scenario scenario() {
        int rows = (SHAPES + COLUMNS - 1) / COLUMNS;
        WorldSpec world = new WorldSpec(
                COLUMNS * PITCH + 2 * AISLE, rows * PITCH + 2 * AISLE, true, MOVING, new CrowdedHall().obstacles());
        RobotSpec robot = RobotSpec.DEFAULT.withPlatform(0.25, 0.20, 0.6);
        SimulationSetup setup = SimulationSetup.of(world, new Pose(0.5, 0.5, 0))
                .withRobot(robot)
                .withDuration(100_000);
        return new Scenario("Crowded hall", "", false, setup, Expectation.NONE);
    }

    private List<Obstacle> obstacles() {
        List<Obstacle> obstacles = new ArrayList<>();
        for (int i = 0; i < SHAPES; i++) {
            obstacles.add(
                    obstacle(i, new Vector2(AISLE + (i % COLUMNS + 0.5) * PITCH, AISLE + (i / COLUMNS + 0.5) * PITCH)));
        }
        return obstacles;
    }

    private Obstacle obstacle(int number, Vector2 place) {
        boolean moves = number % (SHAPES / MOVING) == SHAPES / MOVING / 2;
        Vector2 beside = place.plus(new Vector2(0.3, 0.2));
        WaypointPath motion = moves ? new WaypointPath(0.2, true, List.of(place, beside)) : WaypointPath.NONE;
        return new Obstacle(
                "shape" + number, shape(number % 6), new Pose(place.x(), place.y(), random.nextDouble() * 6), motion);
    }

    private ObstacleShape shape(int kind) {
        double size = 0.06 + 0.06 * random.nextDouble();
        return switch (kind) {
            case 0 -> new ObstacleShape.RectangleShape(2 * size, size);
            case 1 -> new ObstacleShape.CircleShape(size);
            case 2 -> new ObstacleShape.EllipseShape(size, size / 2);
            case 3 -> new ObstacleShape.PolygonShape(star(size));
            case 4 ->
                new ObstacleShape.WallShape(List.of(new Vector2(-size, 0), new Vector2(0, size), new Vector2(size, 0)));
            default -> new ObstacleShape.RectangleShape(size, size);
        };
    }

    private static List<Vector2> star(double size) {
        List<Vector2> points = new ArrayList<>();
        for (int i = 0; i < 10; i++) {
            points.add(Vector2.direction(i * Math.PI / 5).times(i % 2 == 0 ? size : size / 2));
        }
        return points;
    }
}
