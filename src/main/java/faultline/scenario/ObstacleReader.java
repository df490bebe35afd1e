package faultline.scenario;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import faultline.scenario.xml.AttributeReader;
import faultline.scenario.xml.ElementRules;
import faultline.scenario.xml.NumberRange;
import faultline.scenario.xml.ProblemKind;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.ScenarioLimits;
import faultline.scenario.xml.XmlElement;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;

/** Reads obstacles, in the world and in the timeline, and counts the obstacles and points of the file. */
final class ObstacleReader {

    /** The shapes whose surface can be specular. */
    private static final List<String> SPECULAR_SHAPES = List.of("rectangle", "polygon", "wall", "plan");

    private static final List<String> CHILD_ELEMENTS = List.of("motion");

    private final Problems problems;
    private final Map<String, BiFunction<XmlElement, AttributeReader, ObstacleShape>> shapeReaders =
            new LinkedHashMap<>();
    private final List<String> elementNames;
    private int partCount;

    ObstacleReader(Problems problems) {
        this.problems = problems;
        shapeReaders.put(
                "rectangle",
                (node, f) -> new ObstacleShape.RectangleShape(
                        f.number("width", NumberRange.SIZE), f.number("height", NumberRange.SIZE)));
        shapeReaders.put("circle", (node, f) -> new ObstacleShape.CircleShape(f.number("radius", NumberRange.SIZE)));
        shapeReaders.put(
                "ellipse",
                (node, f) -> new ObstacleShape.EllipseShape(
                        f.number("rx", NumberRange.SIZE), f.number("ry", NumberRange.SIZE)));
        shapeReaders.put("polygon", (node, f) -> new ObstacleShape.PolygonShape(readPoints(node, f, 3)));
        shapeReaders.put("wall", (node, f) -> new ObstacleShape.WallShape(readPoints(node, f, 2)));
        shapeReaders.put("plan", this::readPlan);
        elementNames = List.copyOf(shapeReaders.keySet());
    }

    /** Returns the names of the elements that are obstacles. */
    List<String> elementNames() {
        return elementNames;
    }

    /** Returns the obstacle of an element whose name is one of {@link #elementNames()}. */
    Obstacle read(XmlElement node) {
        partCount++;
        ElementRules.checkChildren(node, CHILD_ELEMENTS, problems);
        ElementRules.checkAtMostOne(node, CHILD_ELEMENTS, problems);
        AttributeReader fields = new AttributeReader(node, problems);
        String id = fields.id("id");
        Pose pose = new Pose(
                fields.number("x", NumberRange.COORDINATE),
                fields.number("y", NumberRange.COORDINATE),
                fields.angle("heading", NumberRange.ANGLE, 0));
        ObstacleShape shape = shapeReaders.get(node.name()).apply(node, fields);
        double specular = SPECULAR_SHAPES.contains(node.name())
                ? fields.angle("specular", NumberRange.INCIDENCE_ANGLE, Obstacle.MATT)
                : Obstacle.MATT;
        fields.reportUnknownAndMissing();
        WaypointPath motion = node.firstChild("motion").map(this::readMotion).orElse(WaypointPath.NONE);
        return new Obstacle(id, shape, pose, motion, specular);
    }

    private WaypointPath readMotion(XmlElement node) {
        ElementRules.checkChildren(node, List.of(), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        WaypointPath motion = new WaypointPath(
                fields.number("speed", NumberRange.SPEED), fields.flag("loop", true), readPoints(node, fields, 1));
        fields.reportUnknownAndMissing();
        checkLoopTime(node, motion);
        return motion;
    }

    private void checkLoopTime(XmlElement node, WaypointPath motion) {
        double length = 0;
        for (int i = 0; i < motion.waypoints().size(); i++) {
            length += motion.waypoints()
                    .get(i)
                    .distanceTo(
                            motion.waypoints().get((i + 1) % motion.waypoints().size()));
        }
        if (motion.loop() && length > 0 && length < motion.speed() * ScenarioLimits.MIN_LOOP_TIME) {
            problems.add(
                    node,
                    ProblemKind.LOOP_TIME.with(
                            DecimalText.formatRounded(length / motion.speed()),
                            DecimalText.format(ScenarioLimits.MIN_LOOP_TIME)));
        }
    }

    private ObstacleShape.PlanShape readPlan(XmlElement node, AttributeReader fields) {
        ObstacleShape.PlanShape plan = pointReader(node, fields).plan();
        partCount += plan.pointCount();
        return plan;
    }

    private List<Vector2> readPoints(XmlElement node, AttributeReader fields, int least) {
        List<Vector2> points = pointReader(node, fields).points(least);
        partCount += points.size();
        return points;
    }

    private PointListReader pointReader(XmlElement node, AttributeReader fields) {
        return new PointListReader(node, fields, problems, ScenarioLimits.MAX_PARTS - partCount);
    }

    /** Returns whether the file has more obstacles and points than it may. */
    boolean isFull() {
        return partCount >= ScenarioLimits.MAX_PARTS;
    }
}
