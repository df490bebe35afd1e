package faultline.scenario;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.world.Motion;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/** Makes obstacles of elements, in the world and in the timeline, and counts how many parts the file has had. */
final class ObstacleReader {

    /** The surfaces that can be specular. */
    private static final List<String> FLAT = List.of("rectangle", "polygon", "wall");
    private static final List<String> INSIDE = List.of("motion");

    private final Complaints complaints;
    private final Map<String, Function<Fields, ObstacleShape>> shapes = new LinkedHashMap<>();
    private int parts;

    ObstacleReader(Complaints complaints) {
        this.complaints = complaints;
        shapes.put("rectangle", f -> new ObstacleShape.Rectangle(f.number("width", Range.SIZE), f.number("height", Range.SIZE)));
        shapes.put("circle", f -> new ObstacleShape.Circle(f.number("radius", Range.SIZE)));
        shapes.put("ellipse", f -> new ObstacleShape.Ellipse(f.number("rx", Range.SIZE), f.number("ry", Range.SIZE)));
        shapes.put("polygon", f -> new ObstacleShape.Polygon(points(f, 3)));
        shapes.put("wall", f -> new ObstacleShape.Wall(points(f, 2)));
    }

    /** The names of the elements that are obstacles. */
    List<String> names() {
        return List.copyOf(shapes.keySet());
    }

    /** The obstacle of an element whose name is one of {@link #names()}. */
    Obstacle read(Node node) {
        parts++;
        Content.check(node, INSIDE, complaints);
        Content.atMostOne(node, INSIDE, complaints);
        Fields fields = new Fields(node, complaints);
        String id = fields.id("id");
        Pose pose = new Pose(fields.number("x", Range.COORDINATE), fields.number("y", Range.COORDINATE),
                fields.angle("heading", Range.ANGLE, 0));
        ObstacleShape shape = shapes.get(node.name()).apply(fields);
        double specular = FLAT.contains(node.name()) ? fields.angle("specular", Range.INCIDENCE, Obstacle.MATT) : Obstacle.MATT;
        fields.done();
        Optional<Motion> motion = node.first("motion").map(this::motion);
        return new Obstacle(id, shape, pose, motion, specular);
    }

    private Motion motion(Node node) {
        Content.check(node, List.of(), complaints);
        Fields fields = new Fields(node, complaints);
        Motion motion = new Motion(fields.number("speed", Range.SPEED), fields.flag("loop", true), points(fields, 1));
        fields.done();
        checkLoop(node, motion);
        return motion;
    }

    private void checkLoop(Node node, Motion motion) {
        double length = 0;
        for (int i = 0; i < motion.points().size(); i++) {
            length += motion.points().get(i).distanceTo(motion.points().get((i + 1) % motion.points().size()));
        }
        if (motion.loop() && length > 0 && length < motion.speed() * Limits.QUICKEST_LOOP) {
            complaints.add(node, "<motion> goes round its way-points in " + Numbers.toRoughText(length / motion.speed()) + " s, allowed is "
                    + Numbers.toText(Limits.QUICKEST_LOOP) + " s or more");
        }
    }

    private List<Vec> points(Fields fields, int least) {
        List<Vec> points = fields.points("points", least, Math.max(least, Limits.MOST_PARTS - parts));
        parts += points.size();
        return points;
    }

    /** Whether the file has had more than its share of obstacles and points. */
    boolean isFull() {
        return parts >= Limits.MOST_PARTS;
    }
}
