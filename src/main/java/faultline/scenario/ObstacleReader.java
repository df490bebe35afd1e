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
import java.util.List;

/** Reads obstacles, in the world and in the timeline, and counts the obstacles and points of the file. */
final class ObstacleReader {

    private static final List<String> ELEMENT_NAMES =
            List.of("rectangle", "circle", "ellipse", "polygon", "wall", "plan");

    /** The shapes whose surface can be specular. */
    private static final List<String> SPECULAR_SHAPES = List.of("rectangle", "polygon", "wall", "plan");

    private static final List<String> CHILD_ELEMENTS = List.of("motion");

    private final Problems problems;
    private int partCount;

    ObstacleReader(Problems problems) {
        this.problems = problems;
    }

    /** Returns the names of the elements that are obstacles. */
    List<String> elementNames() {
        return ELEMENT_NAMES;
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
        ObstacleShape shape = readShape(node, fields);
        double specular = SPECULAR_SHAPES.contains(node.name())
                ? fields.angle("specular", NumberRange.INCIDENCE_ANGLE, Obstacle.MATT)
                : Obstacle.MATT;
        fields.reportUnknownAndMissing();
        WaypointPath motion = node.firstChild("motion").map(this::readMotion).orElse(WaypointPath.NONE);
        return new Obstacle(id, shape, pose, motion, specular);
    }

    private ObstacleShape readShape(XmlElement node, AttributeReader fields) {
        return switch (node.name()) {
            case "rectangle" ->
                new ObstacleShape.RectangleShape(
                        fields.number("width", NumberRange.SIZE), fields.number("height", NumberRange.SIZE));
            case "circle" -> new ObstacleShape.CircleShape(fields.number("radius", NumberRange.SIZE));
            case "ellipse" ->
                new ObstacleShape.EllipseShape(
                        fields.number("rx", NumberRange.SIZE), fields.number("ry", NumberRange.SIZE));
            case "polygon" -> new ObstacleShape.PolygonShape(readPoints(node, fields, 3));
            case "wall" -> new ObstacleShape.WallShape(readPoints(node, fields, 2));
            case "plan" -> readPlan(node, fields);
            default -> throw new IllegalArgumentException("no element of an obstacle: " + node.name());
        };
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
        if (motion.isLoopTooShort()) {
            problems.add(
                    node,
                    ProblemKind.LOOP_TIME.with(
                            DecimalText.formatRefused(motion.loopLength() / motion.speed(), WaypointPath.MIN_LOOP_TIME),
                            DecimalText.format(WaypointPath.MIN_LOOP_TIME)));
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
