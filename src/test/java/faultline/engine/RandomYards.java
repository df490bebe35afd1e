package faultline.engine;

import faultline.control.ControllerSpec;
import faultline.geometry.Box;
import faultline.geometry.BoxOracle;
import faultline.geometry.Convex;
import faultline.geometry.Pose;
import faultline.geometry.Segment;
import faultline.geometry.Vec;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.world.Motion;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.Outline;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;

/** Random worlds of all shapes, with a robot that drives blindly; the same on every run. */
final class RandomYards {

    static final double WIDTH = 6;
    static final double HEIGHT = 4;

    private final SplittableRandom random;
    private final RobotSpec robot;
    private final double topSpeed;

    /** Yards for a robot, which drives at up to a speed either way, metres per second. */
    RandomYards(long seed, RobotSpec robot, double topSpeed) {
        this.random = new SplittableRandom(seed);
        this.robot = robot;
        this.topSpeed = topSpeed;
    }

    /** The next yard: the robot starts in the clear; as many obstacles move as asked, as fast as the robot may. */
    Setup next(int movers) {
        Pose start = new Pose(random.nextDouble(0.5, WIDTH - 0.5), random.nextDouble(0.5, HEIGHT - 0.5), random.nextDouble(-10, 10));
        List<Obstacle> obstacles = new ArrayList<>();
        while (obstacles.size() < movers + random.nextInt(2, 6)) {
            Obstacle obstacle = obstacle("o" + obstacles.size(), obstacles.size() < movers);
            if (isClear(obstacle, start)) {
                obstacles.add(obstacle);
            }
        }
        WorldSpec world = new WorldSpec(WIDTH, HEIGHT, true, 3, obstacles);
        MotorSpec motor = new MotorSpec(random.nextBoolean() ? 0 : random.nextDouble(0.2), 1, topSpeed);
        RobotSpec driven = new RobotSpec(robot.length(), robot.width(), robot.track(), robot.speed(), robot.turnRate(), motor, robot.sensors());
        double dt = random.nextBoolean() ? 0.01 : random.nextDouble(0.001, 0.05);
        return new Setup(world, driven, start, drive(), List.of(), dt, random.nextLong(), 1);
    }

    private ControllerSpec drive() {
        double left = random.nextDouble(-topSpeed, topSpeed);
        return new ControllerSpec.Drive(left, random.nextBoolean() ? random.nextDouble(-topSpeed, topSpeed) : left + random.nextDouble(-0.1, 0.1));
    }

    private boolean isClear(Obstacle obstacle, Pose start) {
        Box body = new Box(start, robot.length(), robot.width());
        Outline outline = Outline.of(obstacle);
        return !outline.contains(start.position()) && outline.parts().stream().allMatch(part -> BoxOracle.distance(body, part) > 0.01);
    }

    private Obstacle obstacle(String id, boolean moving) {
        Pose pose = new Pose(random.nextDouble(WIDTH), random.nextDouble(HEIGHT), random.nextDouble(-10, 10));
        Optional<Motion> motion = moving ? Optional.of(motion()) : Optional.empty();
        return new Obstacle(id, shape(), pose, motion);
    }

    private Motion motion() {
        List<Vec> points = new ArrayList<>();
        for (int i = random.nextInt(1, 4); i > 0; i--) {
            points.add(new Vec(random.nextDouble(WIDTH), random.nextDouble(HEIGHT)));
        }
        return new Motion(random.nextDouble(topSpeed), random.nextBoolean(), points);
    }

    /** A shape of any kind, from a millimetre to two metres. */
    ObstacleShape shape() {
        return switch (random.nextInt(5)) {
            case 0 -> new ObstacleShape.Rectangle(length(), length());
            case 1 -> new ObstacleShape.Circle(length());
            case 2 -> new ObstacleShape.Ellipse(length(), length());
            case 3 -> new ObstacleShape.Polygon(List.of(around(), around(), around(), around()));
            default -> new ObstacleShape.Wall(List.of(around(), around(), around()));
        };
    }

    private Vec around() {
        return new Vec(random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    }

    /** From a millimetre to half a metre. */
    private double length() {
        return Math.pow(10, random.nextDouble(-3, -0.3));
    }

    /** What stands in a yard at a moment before any contact: every piece of every outline, and the enclosing wall. */
    static List<Convex> figures(Setup setup, double time) {
        List<Convex> figures = new ArrayList<>(List.of(new Segment(0, 0, WIDTH, 0), new Segment(WIDTH, 0, WIDTH, HEIGHT),
                new Segment(WIDTH, HEIGHT, 0, HEIGHT), new Segment(0, HEIGHT, 0, 0)));
        for (Obstacle obstacle : setup.world().obstacles()) {
            Vec place = obstacle.motion().map(motion -> place(motion, obstacle.pose().position(), time)).orElse(obstacle.pose().position());
            figures.addAll(Outline.of(obstacle.at(new Pose(place.x(), place.y(), obstacle.pose().heading()))).parts());
        }
        return figures;
    }

    /** Where a mover is after a time, by walking its way from the start. */
    private static Vec place(Motion motion, Vec start, double time) {
        double left = motion.speed() * time;
        Vec at = start;
        for (int i = 0; motion.loop() || i < motion.points().size(); i++) {
            Vec target = motion.points().get(i % motion.points().size());
            double length = at.distanceTo(target);
            if (length >= left) {
                return length == 0 ? at : at.plus(target.minus(at).times(left / length));
            }
            if (length == 0 && motion.points().size() == 1) {
                return at;
            }
            left -= length;
            at = target;
        }
        return at;
    }
}
