package faultline.engine;

import faultline.control.ControllerSpec;
import faultline.geometry.BoxDistanceOracle;
import faultline.geometry.ConvexShape;
import faultline.geometry.OrientedBox;
import faultline.geometry.Pose;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import faultline.robot.DriveScale;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.world.Obstacle;
import faultline.world.ObstacleGeometry;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Random worlds of all shapes, with a robot that drives blindly; the same on every run. */
final class RandomWorlds {

    static final double WIDTH = 6;
    static final double HEIGHT = 4;

    private final SplittableRandom random;
    private final RobotSpec robot;
    private final double topSpeed;

    /** Yards for a robot, which drives at up to a speed either way, metres per second. */
    RandomWorlds(long seed, RobotSpec robot, double topSpeed) {
        this.random = new SplittableRandom(seed);
        this.robot = robot;
        this.topSpeed = topSpeed;
    }

    /**
     * Returns the next yard: the robot starts in free space, and a given number of obstacles move, at most as fast as
     * the robot.
     */
    SimulationSetup nextSetup(int movers) {
        Pose start = new Pose(
                random.nextDouble(0.5, WIDTH - 0.5), random.nextDouble(0.5, HEIGHT - 0.5), random.nextDouble(-10, 10));
        List<Obstacle> obstacles = new ArrayList<>();
        while (obstacles.size() < movers + random.nextInt(2, 6)) {
            Obstacle obstacle = randomObstacle("o" + obstacles.size(), obstacles.size() < movers);
            if (isClear(obstacle, start)) {
                obstacles.add(obstacle);
            }
        }
        WorldSpec world = new WorldSpec(WIDTH, HEIGHT, true, 3, obstacles);
        MotorSpec motor = new MotorSpec(random.nextBoolean() ? 0 : random.nextDouble(0.2), 1, topSpeed);
        RobotSpec driven = new RobotSpec(
                robot.length(),
                robot.width(),
                robot.track(),
                robot.speed(),
                robot.turnRate(),
                motor,
                DriveScale.NONE,
                robot.sensors());
        double dt = random.nextBoolean() ? 0.01 : random.nextDouble(0.001, 0.05);
        return SimulationSetup.of(world, start)
                .withRobot(driven)
                .withController(randomDrive())
                .withTick(dt)
                .withSeed(random.nextLong())
                .withDuration(1);
    }

    private ControllerSpec randomDrive() {
        double left = random.nextDouble(-topSpeed, topSpeed);
        return new ControllerSpec.Drive(
                left,
                random.nextBoolean() ? random.nextDouble(-topSpeed, topSpeed) : left + random.nextDouble(-0.1, 0.1));
    }

    private boolean isClear(Obstacle obstacle, Pose start) {
        OrientedBox body = new OrientedBox(start, robot.length(), robot.width());
        ObstacleGeometry outline = ObstacleGeometry.of(obstacle);
        return !outline.contains(start.position())
                && outline.parts().stream().allMatch(part -> BoxDistanceOracle.distance(body, part) > 0.01);
    }

    private Obstacle randomObstacle(String id, boolean moving) {
        Pose pose = new Pose(random.nextDouble(WIDTH), random.nextDouble(HEIGHT), random.nextDouble(-10, 10));
        WaypointPath motion = moving ? randomMotion() : WaypointPath.NONE;
        return new Obstacle(id, randomShape(), pose, motion);
    }

    private WaypointPath randomMotion() {
        List<Vector2> points = new ArrayList<>();
        for (int i = random.nextInt(1, 4); i > 0; i--) {
            points.add(new Vector2(random.nextDouble(WIDTH), random.nextDouble(HEIGHT)));
        }
        return new WaypointPath(random.nextDouble(topSpeed), random.nextBoolean(), points);
    }

    /** A shape of any kind, from a millimetre to two metres. */
    ObstacleShape randomShape() {
        return switch (random.nextInt(5)) {
            case 0 -> new ObstacleShape.RectangleShape(randomLength(), randomLength());
            case 1 -> new ObstacleShape.CircleShape(randomLength());
            case 2 -> new ObstacleShape.EllipseShape(randomLength(), randomLength());
            case 3 ->
                new ObstacleShape.PolygonShape(List.of(randomVertex(), randomVertex(), randomVertex(), randomVertex()));
            default -> new ObstacleShape.WallShape(List.of(randomVertex(), randomVertex(), randomVertex()));
        };
    }

    private Vector2 randomVertex() {
        return new Vector2(random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    }

    /** From a millimetre to half a metre. */
    private double randomLength() {
        return Math.pow(10, random.nextDouble(-3, -0.3));
    }

    /** What stands in a yard at a moment before any contact: every piece of every outline, and the enclosing wall. */
    static List<ConvexShape> shapesAt(SimulationSetup setup, double time) {
        List<ConvexShape> figures = new ArrayList<>(List.of(
                new Segment(0, 0, WIDTH, 0),
                new Segment(WIDTH, 0, WIDTH, HEIGHT),
                new Segment(WIDTH, HEIGHT, 0, HEIGHT),
                new Segment(0, HEIGHT, 0, 0)));
        for (Obstacle obstacle : setup.world().obstacles()) {
            Vector2 start = obstacle.pose().position();
            Vector2 place = obstacle.isMoving() ? positionAt(obstacle.motion(), start, time) : start;
            figures.addAll(ObstacleGeometry.of(obstacle.withPose(obstacle.pose().withPosition(place)))
                    .parts());
        }
        return figures;
    }

    /** Returns the position of a mover after a time, by following its path from the start. */
    private static Vector2 positionAt(WaypointPath motion, Vector2 start, double time) {
        double left = motion.speed() * time;
        Vector2 at = start;
        for (int i = 0; motion.loop() || i < motion.waypoints().size(); i++) {
            Vector2 target = motion.waypoints().get(i % motion.waypoints().size());
            double length = at.distanceTo(target);
            if (length >= left) {
                return length == 0 ? at : at.plus(target.minus(at).times(left / length));
            }
            if (length == 0 && motion.waypoints().size() == 1) {
                return at;
            }
            left -= length;
            at = target;
        }
        return at;
    }
}
