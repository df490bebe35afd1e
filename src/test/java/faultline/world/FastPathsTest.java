package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
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

    /** Volts for the motors of one side. */
    private static final double MAX_VOLTS = 6;

    /** A robot that has collided stands still, so a world ends soon after. */
    private static final int TICKS_AFTER_COLLISION = 10;

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

    /** Near lists are made for a region: here each drive leaves many of them in one direction. */
    @Test
    void everyReadingOfAStraightDriveIsThatOfBruteForce() {
        for (int degrees = 0; degrees < 360; degrees += 15) {
            Pose start = new Pose(10, 10, Math.toRadians(degrees));
            List<Obstacle> posts = new ArrayList<>();
            for (int i = 0; i < 20; i++) {
                Vector2 offset = new Vector2(0.2 * i, (i % 2 == 0 ? 1 : -1) * random.nextDouble(0.3, 1));
                posts.add(new Obstacle(
                        "post" + i,
                        new ObstacleShape.CircleShape(0.05),
                        Pose.ORIGIN.withPosition(start.toParent(offset))));
            }
            WorldSpec spec = new WorldSpec(20, 20, true, 100, posts);
            World world = new World(spec, RobotSpec.DEFAULT, start, DT, 1);
            BruteForceReference reference = new BruteForceReference(world, spec, DT);
            for (int tick = 0; tick < 300; tick++) {
                world.move(MAX_VOLTS, MAX_VOLTS);
                world.sense();
                assertReadings(degrees + " degrees", world, reference);
            }
            double driven = world.pose().position().distanceTo(start.position());
            assertTrue(driven > 2 && world.collision().isEmpty(), degrees + " degrees: " + driven + " m");
        }
    }

    /** In floor plans a sensor has dozens of short segments near it, most of them beside its cone. */
    @Test
    void everyReadingInAFloorPlanIsThatOfBruteForce() {
        for (int i = 0; i < WORLDS / 10; i++) {
            double cell = random.nextDouble(0.02, 0.2);
            WorldSpec spec =
                    new WorldSpec(SIZE, SIZE, true, 100, List.of(new Obstacle("plan", randomCells(cell), Pose.ORIGIN)));
            RobotSpec robot = random.nextBoolean() ? RobotSpec.DEFAULT : robot();
            Pose start = new Pose(random.nextDouble(SIZE), random.nextDouble(SIZE), random.nextDouble(-10, 10));
            if (Clearance.findObstruction(spec, robot, start).isEmpty()) {
                World world = new World(spec, robot, start, DT, 1);
                BruteForceReference reference = new BruteForceReference(world, spec, DT);
                for (int tick = 0; tick < TICKS && world.collision().isEmpty(); tick++) {
                    world.move(random.nextDouble(2, 3), random.nextDouble(2, 3));
                    world.sense();
                    assertReadings("plan " + i, world, reference);
                }
            }
        }
        assertTrue(finiteReadings > 10 * WORLDS, finiteReadings + " readings of something");
    }

    /** Returns a floor plan of square cells, a side of which is given, in groups that touch. */
    private ObstacleShape randomCells(double cell) {
        List<List<Vector2>> rings = new ArrayList<>();
        for (int group = 0; group < 40; group++) {
            int column = random.nextInt((int) (SIZE / cell));
            int row = random.nextInt((int) (SIZE / cell));
            for (int k = 0; k < 8; k++) {
                Vector2 corner = new Vector2(column * cell, row * cell);
                rings.add(List.of(
                        corner,
                        corner.plus(new Vector2(cell, 0)),
                        corner.plus(new Vector2(cell, cell)),
                        corner.plus(new Vector2(0, cell))));
                column += random.nextInt(2);
                row += random.nextInt(3) - 1;
            }
        }
        return new ObstacleShape.PlanShape(rings);
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
        BruteForceReference reference = new BruteForceReference(world, spec, DT);
        double left = random.nextDouble(-MAX_VOLTS, MAX_VOLTS);
        double right = random.nextDouble(-MAX_VOLTS, MAX_VOLTS);
        int standing = 0;
        for (int tick = 0; tick < TICKS && standing < TICKS_AFTER_COLLISION; tick++) {
            if (edited && random.nextInt(20) == 0) {
                edits += world.execute(command(world)).refusal().isEmpty() ? 1 : 0;
            }
            Pose before = world.pose();
            Pose expected = reference.poseAfterTick(left, right);
            world.move(left, right);
            world.sense();
            if (!isMoverMet(world)) {
                assertEquals(expected, world.pose(), () -> name + " from " + before);
            }
            assertReadings(name, world, reference);
            left = changed(left);
            right = changed(right);
            standing += world.collision().isPresent() ? 1 : 0;
        }
        collisions += world.collision().isPresent() ? 1 : 0;
    }

    private double changed(double volts) {
        return Math.max(-MAX_VOLTS, Math.min(MAX_VOLTS, volts + random.nextDouble(-0.3, 0.3)));
    }

    /**
     * Returns whether the robot is in contact with a moving obstacle, whose motion the reference implementation does
     * not compute.
     */
    private static boolean isMoverMet(World world) {
        return world.collision().isPresent()
                && world.obstacles().stream()
                        .anyMatch(obstacle -> obstacle.isMoving()
                                && obstacle.id().equals(world.collision().get().obstacle()));
    }

    private void assertReadings(String name, World world, BruteForceReference reference) {
        double[] readings = reference.readings();
        for (int i = 0; i < readings.length; i++) {
            if (Double.doubleToLongBits(readings[i]) != Double.doubleToLongBits(world.trueReading(i))) {
                fail(name + ", sensor " + i + " at " + world.pose() + ": " + world.trueReading(i) + ", not "
                        + readings[i]);
            }
            finiteReadings += readings[i] < Double.POSITIVE_INFINITY ? 1 : 0;
        }
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
            case 0 -> new ObstacleShape.RectangleShape(length(), length());
            case 1 -> new ObstacleShape.CircleShape(length());
            case 2 -> new ObstacleShape.EllipseShape(length(), length());
            case 3 -> new ObstacleShape.PolygonShape(List.of(vertex(), vertex(), vertex(), vertex()));
            default -> new ObstacleShape.WallShape(List.of(vertex(), vertex(), vertex()));
        };
    }

    private Vector2 vertex() {
        return new Vector2(random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    }

    private double length() {
        return Math.pow(10, random.nextDouble(-3, -0.2));
    }

    private Command command(World world) {
        List<Obstacle> obstacles = world.obstacles();
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
