package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.ConvexShape;
import faultline.geometry.Pose;
import faultline.geometry.Sector;
import faultline.geometry.SectorDistance;
import faultline.geometry.Segment;
import faultline.geometry.SpecularDistance;
import faultline.geometry.Vector2;
import faultline.robot.DifferentialDrive;
import faultline.robot.RobotSpec;
import faultline.robot.WheelSpeeds;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/**
 * Near lists, free travel and the grid agree with brute force to the last bit, in random worlds that stand, move and
 * are edited during the run. The system properties {@code faultline.worlds} and {@code faultline.worlds.seed} set their
 * number and choose others.
 */
class FastPathsTest {

    private static final int WORLDS = Integer.getInteger("faultline.worlds", 400);
    private static final int TICKS = 150;
    private static final double DT = 0.02;
    private static final double SIZE = 6;

    private final SplittableRandom random = new SplittableRandom(Long.getLong("faultline.worlds.seed", 1301));
    private int finiteReadings;
    private int collisions;
    private int edits;

    @Test
    void everyReadingAndEveryMotionIsThatOfBruteForce() {
        for (int i = 0; i < WORLDS; i++) {
            run("world " + i);
        }
        assertTrue(finiteReadings > 100 * WORLDS, finiteReadings + " readings of something");
        assertTrue(collisions > WORLDS / 10, collisions + " collisions");
        assertTrue(edits > 2 * WORLDS, edits + " edits");
    }

    private void run(String name) {
        boolean crowded = random.nextInt(4) == 0;
        boolean moves = random.nextBoolean();
        boolean edited = random.nextBoolean();
        List<Obstacle> obstacles = new ArrayList<>();
        for (int i = crowded ? 40 : random.nextInt(8); i > 0; i--) {
            obstacles.add(obstacle("o" + i, moves && random.nextInt(3) == 0));
        }
        WorldSpec spec = new WorldSpec(SIZE, SIZE, true, 100, obstacles);
        RobotSpec robot = robot();
        Pose start = new Pose(random.nextDouble(SIZE), random.nextDouble(SIZE), random.nextDouble(-10, 10));
        if (Clearance.findObstruction(spec, robot, start).isPresent()) {
            return;
        }
        World world = new World(spec, robot, start, DT, random.nextLong());
        double left = random.nextDouble(-6, 6);
        double right = random.nextDouble(-6, 6);
        for (int tick = 0; tick < TICKS; tick++) {
            if (edited && random.nextInt(20) == 0) {
                edits += world.execute(command(world)).refusal().isEmpty() ? 1 : 0;
            }
            Snapshot before = world.snapshot();
            Pose expected = expectedPose(before, left, right);
            world.move(left, right);
            world.sense();
            Snapshot after = world.snapshot();
            boolean moverMet = after.collision().stream().anyMatch(collision -> isMoving(before, collision.obstacle()));
            if (!moverMet) {
                assertEquals(expected, after.pose(), () -> name + " from " + before.pose());
            }
            assertReadings(name, world, after);
            left = Math.max(-6, Math.min(6, left + random.nextDouble(-0.3, 0.3)));
            right = Math.max(-6, Math.min(6, right + random.nextDouble(-0.3, 0.3)));
        }
        collisions += world.collision().isPresent() ? 1 : 0;
    }

    private static boolean isMoving(Snapshot world, String id) {
        return world.obstacles().stream().anyMatch(obstacle -> obstacle.id().equals(id) && obstacle.isMoving());
    }

    /** Returns the pose after a tick if every static shape is tested for contact. */
    private static Pose expectedPose(Snapshot before, double leftVolts, double rightVolts) {
        if (before.collision().isPresent()) {
            return before.pose();
        }
        RobotSpec robot = before.robot();
        WheelSpeeds speeds = robot.motor()
                .step(before.wheelSpeeds(), leftVolts, rightVolts, robot.motor().decay(DT));
        TimeOfImpact impact = new TimeOfImpact(robot.length(), robot.width(), speeds.toVelocity(robot.track()));
        double stop = DT;
        for (ShapeOf shape : shapes(before)) {
            if (!shape.moving()) {
                stop = Math.min(stop, impact.firstContactTime(before.pose(), shape.shape(), Vector2.ZERO, stop));
            }
        }
        return DifferentialDrive.advance(before.pose(), speeds.toVelocity(robot.track()), stop);
    }

    private record ShapeOf(ConvexShape shape, double specularAngle, boolean moving) {}

    private static List<ShapeOf> shapes(Snapshot world) {
        List<ShapeOf> shapes = new ArrayList<>();
        double w = world.width();
        double h = world.height();
        for (Segment side : List.of(
                new Segment(0, 0, w, 0), new Segment(w, 0, w, h), new Segment(w, h, 0, h), new Segment(0, h, 0, 0))) {
            shapes.add(new ShapeOf(side, Obstacle.MATT, false));
        }
        for (Obstacle obstacle : world.obstacles()) {
            ObstacleGeometry.of(obstacle)
                    .parts()
                    .forEach(part -> shapes.add(new ShapeOf(part, obstacle.specularAngle(), obstacle.isMoving())));
        }
        return shapes;
    }

    private void assertReadings(String name, World world, Snapshot after) {
        List<ShapeOf> shapes = shapes(after);
        for (int i = 0; i < after.sensors().size(); i++) {
            double expected = expectedReading(after, after.sensors().get(i), shapes);
            int sensor = i;
            assertEquals(
                    Double.doubleToLongBits(expected),
                    Double.doubleToLongBits(world.trueReading(i)),
                    () -> name + ", sensor " + sensor + " at " + after.pose() + ": " + world.trueReading(sensor)
                            + ", not " + expected);
            finiteReadings += expected < Double.POSITIVE_INFINITY ? 1 : 0;
        }
    }

    private static double expectedReading(Snapshot world, SensorSnapshot sensor, List<ShapeOf> shapes) {
        Sector sector = sensor.sector();
        Vector2 mount = sensor.spec().mountPosition();
        boolean outside = Math.abs(mount.x()) > world.robot().length() / 2
                || Math.abs(mount.y()) > world.robot().width() / 2;
        if (outside
                && world.obstacles().stream()
                        .anyMatch(obstacle -> ObstacleGeometry.of(obstacle).contains(sector.apex()))) {
            return 0;
        }
        double least = Double.POSITIVE_INFINITY;
        for (ShapeOf shape : shapes) {
            double distance = shape.specularAngle() < Obstacle.MATT && shape.shape() instanceof Segment segment
                    ? SpecularDistance.nearest(sector, segment, shape.specularAngle())
                    : SectorDistance.nearest(sector, shape.shape());
            least = Math.min(least, distance);
        }
        return least;
    }

    /** Returns the standard robot with cones and ranges of any size, and some sensors mounted outside the body. */
    private RobotSpec robot() {
        List<SensorSpec> sensors = new ArrayList<>();
        for (SensorSpec sensor : RobotSpec.DEFAULT.sensors()) {
            sensors.add(sensor.withRange(Math.pow(10, random.nextDouble(-1.5, 1)))
                    .withCone(Math.toRadians(random.nextDouble(0.1, 179)))
                    .withBearing(random.nextDouble(-7, 7))
                    .withMountPosition(sensor.mountPosition().times(random.nextInt(5) == 0 ? 3 : 1)));
        }
        return RobotSpec.DEFAULT.withSensors(sensors);
    }

    private Obstacle obstacle(String id, boolean moving) {
        Pose pose = new Pose(random.nextDouble(SIZE), random.nextDouble(SIZE), random.nextDouble(-10, 10));
        WaypointPath path = !moving
                ? WaypointPath.NONE
                : new WaypointPath(
                        random.nextDouble(2),
                        random.nextBoolean(),
                        List.of(
                                new Vector2(random.nextDouble(SIZE), random.nextDouble(SIZE)),
                                new Vector2(random.nextDouble(SIZE), random.nextDouble(SIZE))));
        ObstacleShape shape = shape();
        double specular = shape.isFlat() && random.nextInt(3) == 0 ? random.nextDouble(0.05, 1.5) : Obstacle.MATT;
        return new Obstacle(id, shape, pose, path, specular);
    }

    private ObstacleShape shape() {
        return switch (random.nextInt(5)) {
            case 0 -> new ObstacleShape.Rectangle(length(), length());
            case 1 -> new ObstacleShape.Circle(length());
            case 2 -> new ObstacleShape.Ellipse(length(), length());
            case 3 -> new ObstacleShape.Polygon(List.of(vertex(), vertex(), vertex(), vertex()));
            default -> new ObstacleShape.Wall(List.of(vertex(), vertex(), vertex()));
        };
    }

    private Vector2 vertex() {
        return new Vector2(random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    }

    private double length() {
        return Math.pow(10, random.nextDouble(-3, -0.2));
    }

    private Command command(World world) {
        List<Obstacle> obstacles = world.snapshot().obstacles();
        Optional<Obstacle> any =
                obstacles.isEmpty() ? Optional.empty() : Optional.of(obstacles.get(random.nextInt(obstacles.size())));
        Pose pose = new Pose(random.nextDouble(SIZE), random.nextDouble(SIZE), random.nextDouble(-10, 10));
        SensorSpec sensor = world.robot().sensors().get(random.nextInt(8));
        return switch (random.nextInt(6)) {
            case 0 -> new Command.PlaceObstacle(obstacle("o" + random.nextInt(60), random.nextInt(4) == 0));
            case 1 ->
                any.<Command>map(o -> new Command.RemoveObstacle(o.id())).orElse(new Command.RemoveObstacle("none"));
            case 2, 3 ->
                any.<Command>map(o -> new Command.MoveObstacle(o.id(), pose))
                        .orElse(new Command.MoveObstacle("none", pose));
            case 4 -> new Command.SetPlatform(random.nextDouble(0.1, 0.4), random.nextDouble(0.1, 0.4), 0.3);
            default ->
                new Command.ConfigureSensor(
                        sensor.withBearing(random.nextDouble(-7, 7)).withRange(random.nextDouble(0.1, 5)));
        };
    }
}
