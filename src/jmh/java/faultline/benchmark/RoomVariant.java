package faultline.benchmark;

import faultline.engine.SimulationSetup;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;

/** Rooms that differ from those of {@link BenchmarkRooms} in one respect each. */
public enum RoomVariant {
    /** 10 000 circles. */
    CIRCLES(() ->
            withShapes(10_000, shape -> new ObstacleShape.CircleShape(Math.min(shape.width(), shape.height()) / 2))),
    /** 10 000 ellipses. */
    ELLIPSES(() -> withShapes(10_000, shape -> new ObstacleShape.EllipseShape(shape.width() / 2, shape.height() / 2))),
    /** 10 000 polygons of five corners. */
    POLYGONS(() -> withShapes(10_000, RoomVariant::pentagon)),
    /** 400 segments that are sensed up to 20 degrees from the normal only. */
    GLOSS(() -> withObstacles(400, obstacle -> obstacle.withSpecularAngle(Degrees.toRadians(20)))),
    /** 400 segments, noise of 1 cm on every sensor. */
    NOISE(() -> withSensors(400, sensor -> sensor.withNoise(0.01))),
    /** 400 segments, 64 sensors of 0.8 m and 30 degrees. */
    SENSORS_64(() -> withManySensors(64)),
    /** 40 000 segments, cones of 170 degrees and 20 m. */
    WIDE_AND_LONG(() -> withSensors(40_000, sensor -> sensor.withRange(20).withCone(Degrees.toRadians(170)))),
    /** 40 000 segments, cones of 30 degrees and 20 m. */
    LONG(() -> withSensors(40_000, sensor -> sensor.withRange(20))),
    /** 400 segments, cones of 170 degrees and 0.8 m. */
    WIDE(() -> withSensors(400, sensor -> sensor.withCone(Degrees.toRadians(170)))),
    /** 4000 segments and 1000 moving circles. */
    MOVERS_1000(() -> withMovers(1000));

    private static final int EDGES = 4;

    private final Supplier<SimulationSetup> maker;

    RoomVariant(Supplier<SimulationSetup> maker) {
        this.maker = maker;
    }

    /** Returns a new setup. */
    SimulationSetup setup() {
        return maker.get();
    }

    private static SimulationSetup withObstacles(int segments, UnaryOperator<Obstacle> change) {
        SimulationSetup setup = BenchmarkRooms.of(segments);
        WorldSpec world = setup.world();
        return setup.withWorld(new WorldSpec(
                world.width(),
                world.height(),
                true,
                0,
                world.obstacles().stream().map(change).toList()));
    }

    private static SimulationSetup withShapes(int count, Function<ObstacleShape.RectangleShape, ObstacleShape> shape) {
        return withObstacles(
                EDGES * (count + 1),
                obstacle -> obstacle.withShape(shape.apply((ObstacleShape.RectangleShape) obstacle.shape())));
    }

    private static ObstacleShape pentagon(ObstacleShape.RectangleShape shape) {
        double x = shape.width() / 2;
        double y = shape.height() / 2;
        return new ObstacleShape.PolygonShape(List.of(
                new Vector2(x, 0),
                new Vector2(0, y),
                new Vector2(-x, 0),
                new Vector2(-x / 2, -y),
                new Vector2(x / 2, -y)));
    }

    private static SimulationSetup withSensors(int segments, UnaryOperator<SensorSpec> change) {
        SimulationSetup setup = BenchmarkRooms.of(segments);
        RobotSpec robot = setup.robot();
        return setup.withRobot(
                robot.withSensors(robot.sensors().stream().map(change).toList()));
    }

    private static SimulationSetup withManySensors(int count) {
        SimulationSetup setup = BenchmarkRooms.of(400);
        List<SensorSpec> sensors = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double bearing = 2 * Math.PI * i / count;
            Vector2 mount = new Vector2(0.1 * Math.cos(bearing), 0.1 * Math.sin(bearing));
            sensors.add(new SensorSpec("s" + i, mount, bearing, 0.8, Degrees.toRadians(30), true, 0));
        }
        return setup.withRobot(setup.robot().withSensors(sensors));
    }

    private static SimulationSetup withMovers(int count) {
        SimulationSetup setup = BenchmarkRooms.of(4000);
        double side = setup.world().width();
        Vector2 middle = new Vector2(side / 2, side / 2);
        SplittableRandom random = new SplittableRandom(5);
        List<Obstacle> obstacles = new ArrayList<>(setup.world().obstacles());
        for (int i = 0; i < count; i++) {
            Vector2 place;
            do {
                place = new Vector2(random.nextDouble(side), random.nextDouble(side));
            } while (place.distanceTo(middle) < 2.5);
            WaypointPath path = new WaypointPath(0.2, true, List.of(place, place.plus(new Vector2(1, 0))));
            obstacles.add(
                    new Obstacle("m" + i, new ObstacleShape.CircleShape(0.1), new Pose(place.x(), place.y(), 0), path));
        }
        return setup.withWorld(new WorldSpec(side, side, true, count, obstacles));
    }
}
