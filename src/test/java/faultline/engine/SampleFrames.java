package faultline.engine;

import faultline.control.FollowerState;
import faultline.control.Telemetry;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Sector;
import faultline.geometry.Vector2;
import faultline.robot.DriveScale;
import faultline.robot.MotorFaults;
import faultline.robot.RobotSpec;
import faultline.robot.WheelSpeeds;
import faultline.sensor.Fault;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import faultline.world.Collision;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.SensorSnapshot;
import faultline.world.Snapshot;
import faultline.world.WaypointPath;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Frames that are constructed without running a world, for tests of painting: the test defines exactly what is visible.
 */
public final class SampleFrames {

    /** A robot of the default size without sensors. */
    public static final RobotSpec SENSORLESS =
            new RobotSpec(0.25, 0.20, 0.18, 0.3, 1, RobotSpec.DEFAULT.motor(), DriveScale.NONE, List.of());

    /** Reads nothing within range. */
    public static final Reading NOTHING = new Reading(Reading.NOTHING);

    private SampleFrames() {}

    /** An enclosed world of 6 m x 4 m with a blind robot and obstacles. */
    public static Frame frameOf(Pose robot, Obstacle... obstacles) {
        return frameOf(robot, pathThrough(robot.position()), List.of(), obstacles);
    }

    public static Frame frameOf(Pose robot, RobotPath path, List<SensorSnapshot> sensors, Obstacle... obstacles) {
        return frame(robot, path, sensors, List.of(obstacles), List.of(), Optional.empty());
    }

    public static Frame frame(
            Pose robot,
            RobotPath path,
            List<SensorSnapshot> sensors,
            List<Obstacle> obstacles,
            List<Vector2> contacts,
            Optional<Collision> collision) {
        Snapshot world = new Snapshot(
                1,
                0.01,
                6,
                4,
                true,
                robotWith(sensors),
                robot,
                new WheelSpeeds(0, 0),
                MotorFaults.NONE,
                sensors,
                obstacles,
                contacts,
                collision.stream().toList());
        return new Frame(world, Telemetry.ofState(FollowerState.FOLLOW), 0, 0, path, 0);
    }

    private static RobotSpec robotWith(List<SensorSnapshot> sensors) {
        return SENSORLESS.withSensors(sensors.stream().map(SensorSnapshot::spec).toList());
    }

    /** A path through points. */
    public static RobotPath pathThrough(Vector2... points) {
        return pathRecorder(points).view();
    }

    /** A path on which something is faulty from a point on. */
    public static RobotPath pathWithFault(int from, Vector2... points) {
        PathRecorder recorder = new PathRecorder();
        for (int i = 0; i < points.length; i++) {
            recorder.record(points[i].x(), points[i].y(), PathTag.of(FollowerState.FOLLOW, i >= from));
        }
        return recorder.view();
    }

    /** A recording of a path that can go on. */
    static PathRecorder pathRecorder(Vector2... points) {
        PathRecorder recorder = new PathRecorder();
        for (Vector2 point : points) {
            recorder.record(point.x(), point.y(), PathTag.NONE);
        }
        return recorder;
    }

    /** Two views of one path, the second longer than the first. */
    public static List<RobotPath> growingPathViews(List<Vector2> before, List<Vector2> after) {
        PathRecorder recorder = pathRecorder(before.toArray(Vector2[]::new));
        RobotPath first = recorder.view();
        after.forEach(point -> recorder.record(point.x(), point.y(), PathTag.NONE));
        return List.of(first, recorder.view());
    }

    /** A sound sensor of a robot at a pose. */
    public static SensorSnapshot sensor(SensorSpec spec, Pose robot, Reading reading, Vector2... hits) {
        return new SensorSnapshot(spec, sector(spec, robot), reading, reading, List.of(hits), List.of());
    }

    /** A faulty sensor of a robot at a pose. */
    public static SensorSnapshot faultySensor(
            SensorSpec spec, Pose robot, Reading truth, Reading reported, Fault... faults) {
        return new SensorSnapshot(spec, sector(spec, robot), truth, reported, List.of(), List.of(faults));
    }

    private static Sector sector(SensorSpec spec, Pose robot) {
        return Sector.of(
                robot.toParent(spec.mountPosition()), robot.heading() + spec.bearing(), spec.cone(), spec.range());
    }

    /** A room with some of everything that can be painted, each fault kind and a collision included. */
    public static Frame fullFrame() {
        Pose robot = new Pose(2.2, 1.2, Degrees.toRadians(20));
        List<Obstacle> obstacles = List.of(
                new Obstacle(
                        "table",
                        new ObstacleShape.RectangleShape(1.4, 0.5),
                        new Pose(3.08, 1.62, Degrees.toRadians(30))),
                new Obstacle(
                        "box", new ObstacleShape.RectangleShape(0.5, 0.3), new Pose(3.2, 3.2, Degrees.toRadians(-22))),
                new Obstacle(
                        "sofa", new ObstacleShape.EllipseShape(0.5, 0.25), new Pose(1.1, 3.2, Degrees.toRadians(15))),
                new Obstacle("pole", new ObstacleShape.CircleShape(0.02), new Pose(1.7, 1.75, 0)),
                new Obstacle(
                        "niche",
                        new ObstacleShape.PolygonShape(List.of(
                                new Vector2(0, 0), new Vector2(1, 0), new Vector2(1, 0.9), new Vector2(0.5, 0.4))),
                        new Pose(4.8, 0.3, 0)),
                new Obstacle(
                        "partition",
                        new ObstacleShape.WallShape(
                                List.of(new Vector2(0, 0), new Vector2(0.8, 0), new Vector2(0.8, 0.7))),
                        new Pose(0, 2.2, 0)),
                new Obstacle(
                        "visitor",
                        new ObstacleShape.CircleShape(0.3),
                        new Pose(4.6, 2.9, 0),
                        new WaypointPath(
                                0.2,
                                true,
                                List.of(new Vector2(3.9, 2.4), new Vector2(5.5, 2.4), new Vector2(5.5, 3.5)))));
        Collision collision = collisionWithFaults();
        return frame(
                robot, curve(robot), sensors(robot), obstacles, List.of(collision.point()), Optional.of(collision));
    }

    private static Collision collisionWithFaults() {
        return new Collision(
                new Vector2(2.42, 1.245),
                12.48,
                1248,
                "table",
                Map.of("left", List.of(new Fault.Stuck(0.4)), "rear", List.of(new Fault.Dead())),
                List.of("rear-right"),
                MotorFaults.NONE);
    }

    private static List<SensorSnapshot> sensors(Pose robot) {
        List<SensorSpec> specs = RobotSpec.DEFAULT.sensors();
        List<SensorSnapshot> sensors = new ArrayList<>();
        sensors.add(
                sensor(specs.get(0), robot, new Reading(0.24), new Vector2(2.592, 1.234), new Vector2(2.535, 1.37)));
        sensors.add(sensor(specs.get(1), robot, NOTHING));
        sensors.add(faultySensor(specs.get(2), robot, new Reading(0.62), new Reading(0.4), new Fault.Stuck(0.4)));
        sensors.add(faultySensor(specs.get(3), robot, NOTHING, NOTHING, new Fault.Bias(0.05)));
        sensors.add(faultySensor(specs.get(4), robot, NOTHING, new Reading(Reading.OFF), new Fault.Dead()));
        sensors.add(sensor(specs.get(5).withOn(false), robot, new Reading(Reading.OFF)));
        sensors.add(faultySensor(specs.get(6), robot, NOTHING, NOTHING, new Fault.Dropout(0.5)));
        sensors.add(sensor(specs.get(7), robot, NOTHING));
        return sensors;
    }

    private static RobotPath curve(Pose end) {
        List<Vector2> points = new ArrayList<>();
        for (int i = 0; i < 3000; i++) {
            double a = i * 0.005;
            points.add(new Vector2(
                    3 + (2.6 - 0.1 * Math.sin(5 * a)) * Math.cos(a), 2 + (1.6 - 0.08 * Math.cos(4 * a)) * Math.sin(a)));
        }
        points.add(end.position());
        return pathThrough(points.toArray(Vector2[]::new));
    }
}
