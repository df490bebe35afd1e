package faultline.benchmark;

import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;

/** A room of {@link BenchmarkRooms} as a text that the programs under {@code src/peers} read. */
final class PeerRoom {

    private static final int POSES = 500;
    private static final long SEED = 13;
    /** Of the centre from everything at a pose, metres; more than the half diagonal of the robot. */
    private static final double FREE = 0.17;
    /**
     * From the enclosing wall to the polygons in it, metres. Enki moves what crosses the wall, so the parts beyond,
     * which no sensor sees, are cut off.
     */
    private static final double MARGIN = 1e-6;

    private final SimulationSetup setup;
    private final double side;

    PeerRoom(SimulationSetup setup) {
        this.setup = setup;
        side = setup.world().width();
    }

    /** Returns the room, a line for each thing. Lengths are metres, angles radians. */
    String text() {
        RobotSpec robot = setup.robot();
        ControllerSpec.Drive drive = (ControllerSpec.Drive) setup.controller();
        SensorSpec first = robot.sensors().get(0);
        StringBuilder text = new StringBuilder();
        add(text, "side", side);
        add(text, "robot", robot.length(), robot.width(), robot.track());
        double speed = robot.motor().speedConstant();
        add(text, "wheels", speed * drive.leftVolts(), speed * drive.rightVolts());
        add(text, "cone", first.range(), first.cone());
        addPose(text, "start", setup.start());
        for (SensorSpec sensor : robot.sensors()) {
            Vector2 mount = sensor.mountPosition();
            add(text, "sensor", mount.x(), mount.y(), sensor.bearing());
        }
        for (Obstacle obstacle : setup.world().obstacles()) {
            add(
                    text,
                    "polygon",
                    corners(obstacle).stream()
                            .flatMap(corner -> Stream.of(corner.x(), corner.y()))
                            .mapToDouble(Double::doubleValue)
                            .toArray());
        }
        poses().forEach(pose -> addPose(text, "pose", pose));
        return text.toString();
    }

    private static void addPose(StringBuilder text, String word, Pose pose) {
        add(text, word, pose.x(), pose.y(), pose.heading());
    }

    private static void add(StringBuilder text, String word, double... numbers) {
        text.append(word);
        for (double number : numbers) {
            text.append(String.format(Locale.ROOT, " %.12f", number));
        }
        text.append('\n');
    }

    /** Returns the corners of the part of a rectangle that is inside the enclosing wall, counter-clockwise. */
    private List<Vector2> corners(Obstacle obstacle) {
        ObstacleShape.RectangleShape shape = (ObstacleShape.RectangleShape) obstacle.shape();
        double x = shape.width() / 2;
        double y = shape.height() / 2;
        List<Vector2> corners = Stream.of(
                        new Vector2(x, y), new Vector2(-x, y), new Vector2(-x, -y), new Vector2(x, -y))
                .map(obstacle.pose()::toParent)
                .toList();
        corners = cut(corners, corner -> corner.x() - MARGIN);
        corners = cut(corners, corner -> corner.y() - MARGIN);
        corners = cut(corners, corner -> side - MARGIN - corner.x());
        return cut(corners, corner -> side - MARGIN - corner.y());
    }

    /** Returns the part of a convex polygon where a linear function is not negative. */
    private static List<Vector2> cut(List<Vector2> corners, ToDoubleFunction<Vector2> inside) {
        List<Vector2> kept = new ArrayList<>();
        for (int i = 0; i < corners.size(); i++) {
            Vector2 from = corners.get(i);
            Vector2 to = corners.get((i + 1) % corners.size());
            double before = inside.applyAsDouble(from);
            double after = inside.applyAsDouble(to);
            if (before >= 0) {
                kept.add(from);
            }
            if (before * after < 0) {
                kept.add(from.plus(to.minus(from).times(before / (before - after))));
            }
        }
        return kept;
    }

    /** Returns random poses at which the robot touches nothing, the same for each call. */
    List<Pose> poses() {
        SplittableRandom random = new SplittableRandom(SEED);
        List<Pose> poses = new ArrayList<>();
        while (poses.size() < POSES) {
            Pose pose = new Pose(
                    random.nextDouble(FREE, side - FREE),
                    random.nextDouble(FREE, side - FREE),
                    random.nextDouble(2 * Math.PI));
            if (setup.world().obstacles().stream().allMatch(obstacle -> distance(obstacle, pose) > FREE)) {
                poses.add(pose);
            }
        }
        return poses;
    }

    private static double distance(Obstacle obstacle, Pose pose) {
        ObstacleShape.RectangleShape shape = (ObstacleShape.RectangleShape) obstacle.shape();
        Vector2 local = obstacle.pose().toLocal(pose.position());
        return Math.hypot(
                Math.max(0, Math.abs(local.x()) - shape.width() / 2),
                Math.max(0, Math.abs(local.y()) - shape.height() / 2));
    }
}
