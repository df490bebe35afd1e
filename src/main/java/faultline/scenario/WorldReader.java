package faultline.scenario;

import faultline.world.Obstacle;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Makes the world of its element. */
final class WorldReader {

    private final Complaints complaints;
    private final ObstacleReader obstacles;
    private final Map<String, Place> ids = new LinkedHashMap<>();
    private int moving;

    WorldReader(Complaints complaints, ObstacleReader obstacles) {
        this.complaints = complaints;
        this.obstacles = obstacles;
    }

    WorldSpec read(Node node) {
        Content.check(node, obstacles.names(), complaints);
        Fields fields = new Fields(node, complaints);
        double width = fields.number("width", Range.SIZE);
        double height = fields.number("height", Range.SIZE);
        boolean enclosed = fields.flag("enclosed", true);
        int maxMoving = (int) fields.whole("maxMoving", 0, Limits.MOST_PARTS, WorldSpec.DEFAULT_MAX_MOVING);
        fields.done();
        List<Obstacle> list = obstacles(node, maxMoving);
        return new WorldSpec(width, height, enclosed, Math.max(maxMoving, moving), complaints.isEmpty() ? list : List.of());
    }

    /** The ids of all obstacles that were read, in the file's order. */
    Set<String> ids() {
        return ids.keySet();
    }

    private List<Obstacle> obstacles(Node world, int maxMoving) {
        List<Obstacle> list = new ArrayList<>();
        for (Node child : world.children()) {
            if (obstacles.isFull()) {
                complaints.add(child, "<world> holds too much, allowed is " + Limits.MOST_PARTS + " obstacles and points together");
                return list;
            }
            if (obstacles.names().contains(child.name())) {
                Obstacle obstacle = obstacles.read(child);
                checkId(child, obstacle.id());
                checkMotion(child, obstacle, maxMoving);
                list.add(obstacle);
            }
        }
        return list;
    }

    private void checkId(Node node, String id) {
        if (id.equals(WorldSpec.ENCLOSURE)) {
            complaints.add(node, reserved(node));
        }
        UniqueIds.check(node, id, ids, complaints);
    }

    /** The complaint about an obstacle that is called like the wall round the world. */
    static String reserved(Node node) {
        return "id of <" + node.name() + "> is \"" + WorldSpec.ENCLOSURE + "\", allowed is any other: it names the wall round the world";
    }

    private void checkMotion(Node node, Obstacle obstacle, int maxMoving) {
        if (obstacle.motion().isPresent() && ++moving > maxMoving) {
            complaints.add(node, "<" + node.name() + "> " + Quoting.quoted(obstacle.id()) + " is moving obstacle number " + moving
                    + ", allowed is " + maxMoving + " (maxMoving of <world>)");
        }
    }
}
