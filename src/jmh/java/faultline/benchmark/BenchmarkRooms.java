package faultline.benchmark;

import faultline.control.ControllerSpec;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Rooms of any number of wall segments at one density, the same on every run: an enclosing wall, rotated rectangles,
 * one to a square metre, and a robot that drives a circle in a clearing in the middle, with the eight standard sensors
 * at 0.8 m and 30 degrees.
 */
final class BenchmarkRooms {

    private static final long SEED = 2026;
    private static final double DT = 0.01;
    private static final double CLEARING = 0.75;
    private static final double INNER_SPEED = 0.2;
    private static final double OUTER_SPEED = 0.3;

    private BenchmarkRooms() {}

    /**
     * A room.
     *
     * @param segments how many wall segments, a multiple of four
     * @return a setup that never collides
     */
    static SimulationSetup of(int segments) {
        int rectangles = segments / 4 - 1;
        double side = Math.max(3, Math.sqrt(rectangles));
        Vector2 middle = new Vector2(side / 2, side / 2);
        RobotSpec robot = robot();
        double radius = robot.track() / 2 * (OUTER_SPEED + INNER_SPEED) / (OUTER_SPEED - INNER_SPEED);
        ControllerSpec circle = new ControllerSpec.Drive(
                robot.motor().voltageFor(INNER_SPEED), robot.motor().voltageFor(OUTER_SPEED));
        WorldSpec world = new WorldSpec(side, side, true, 0, rectangles(rectangles, side, middle));
        return SimulationSetup.of(world, new Pose(middle.x(), middle.y() - radius, 0))
                .withRobot(robot)
                .withController(circle)
                .withTick(DT)
                .withSeed(SEED)
                .withDuration(3600);
    }

    /**
     * Ends a run.
     *
     * @param simulation the run
     * @throws IllegalStateException if the robot has collided: it stands still, and its ticks would say nothing
     */
    static void close(Simulation simulation) {
        boolean collided = simulation.collision().isPresent();
        simulation.close();
        if (collided) {
            throw new IllegalStateException("the robot collided: the figures are worthless");
        }
    }

    private static RobotSpec robot() {
        RobotSpec robot = RobotSpec.DEFAULT;
        for (SensorSpec sensor : robot.sensors()) {
            robot = robot.withSensor(sensor.withRange(0.8).withCone(Degrees.toRadians(30)));
        }
        return robot;
    }

    private static List<Obstacle> rectangles(int count, double side, Vector2 middle) {
        SplittableRandom random = new SplittableRandom(SEED);
        List<Obstacle> obstacles = new ArrayList<>();
        while (obstacles.size() < count) {
            ObstacleShape.RectangleShape shape =
                    new ObstacleShape.RectangleShape(random.nextDouble(0.1, 0.5), random.nextDouble(0.1, 0.5));
            Pose pose = new Pose(random.nextDouble(side), random.nextDouble(side), random.nextDouble(2 * Math.PI));
            double reach = Math.hypot(shape.width(), shape.height()) / 2;
            if (pose.position().distanceTo(middle) > CLEARING + reach) {
                obstacles.add(new Obstacle("r" + obstacles.size(), shape, pose));
            }
        }
        return obstacles;
    }
}
