package faultline.scenario;

import faultline.io.Message;
import faultline.io.MessageText;
import faultline.scenario.xml.AttributeReader;
import faultline.scenario.xml.ElementRules;
import faultline.scenario.xml.NumberRange;
import faultline.scenario.xml.ProblemKind;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.ScenarioLimits;
import faultline.scenario.xml.SourceLocation;
import faultline.scenario.xml.XmlElement;
import faultline.world.Obstacle;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Reads the world. */
final class WorldReader {

    private final Problems problems;
    private final ObstacleReader obstacles;
    private final Map<String, SourceLocation> ids = new LinkedHashMap<>();
    private int movingCount;

    WorldReader(Problems problems, ObstacleReader obstacles) {
        this.problems = problems;
        this.obstacles = obstacles;
    }

    WorldSpec read(XmlElement node) {
        ElementRules.checkChildren(node, obstacles.elementNames(), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        double width = fields.number("width", NumberRange.SIZE);
        double height = fields.number("height", NumberRange.SIZE);
        boolean enclosed = fields.flag("enclosed", true);
        int maxMoving = (int) fields.integer("maxMoving", 0, ScenarioLimits.MAX_PARTS, WorldSpec.DEFAULT_MAX_MOVING);
        fields.reportUnknownAndMissing();
        List<Obstacle> list = obstacles(node, maxMoving);
        return new WorldSpec(
                width, height, enclosed, Math.max(maxMoving, movingCount), problems.isEmpty() ? list : List.of());
    }

    /** Returns the ids of all obstacles that were read, in the order of the file. */
    Set<String> ids() {
        return ids.keySet();
    }

    private List<Obstacle> obstacles(XmlElement world, int maxMoving) {
        List<Obstacle> list = new ArrayList<>();
        for (XmlElement child : world.children()) {
            if (obstacles.isFull()) {
                problems.add(child, ProblemKind.TOO_MANY_PARTS.with(ScenarioLimits.MAX_PARTS));
                return list;
            }
            if (obstacles.elementNames().contains(child.name())) {
                Obstacle obstacle = obstacles.read(child);
                checkId(child, obstacle.id());
                checkMotion(child, obstacle, maxMoving);
                list.add(obstacle);
            }
        }
        return list;
    }

    private void checkId(XmlElement node, String id) {
        if (id.equals(WorldSpec.ENCLOSURE)) {
            problems.add(node, reservedId(node));
        }
        ElementRules.checkUniqueId(node, id, ids, problems);
    }

    /** Returns the problem of an obstacle with the name of the enclosing wall. */
    static Message reservedId(XmlElement node) {
        return ProblemKind.RESERVED_ID.with(node.name(), WorldSpec.ENCLOSURE);
    }

    private void checkMotion(XmlElement node, Obstacle obstacle, int maxMoving) {
        if (obstacle.isMoving() && ++movingCount > maxMoving) {
            problems.add(
                    node,
                    ProblemKind.TOO_MANY_MOVING.with(
                            node.name(), MessageText.excerpt(obstacle.id()), movingCount, maxMoving));
        }
    }
}
