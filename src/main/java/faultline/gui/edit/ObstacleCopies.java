package faultline.gui.edit;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import faultline.world.WaypointPath;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Copies obstacles. */
public final class ObstacleCopies {

    private static final Vector2 OFFSET = new Vector2(0.2, -0.2);

    private ObstacleCopies() {}

    /**
     * Returns copies with new ids that are not taken, a little to the right and below the originals, or at the same
     * place if none of the originals exists any more.
     */
    public static List<Obstacle> copyOf(List<Obstacle> originals, Collection<String> taken) {
        Vector2 by = originals.stream().map(Obstacle::id).anyMatch(taken::contains) ? OFFSET : Vector2.ZERO;
        Set<String> ids = new HashSet<>(taken);
        List<Obstacle> copies = new ArrayList<>();
        for (Obstacle original : originals) {
            String id = IdGenerator.uniqueId(original.id(), ids);
            ids.add(id);
            copies.add(moved(original, id, by));
        }
        return copies;
    }

    /** Returns obstacles displaced as a group, with their routes. */
    public static List<Obstacle> displaced(List<Obstacle> obstacles, Vector2 by) {
        return obstacles.stream()
                .map(obstacle -> moved(obstacle, obstacle.id(), by))
                .toList();
    }

    private static Obstacle moved(Obstacle original, String id, Vector2 by) {
        Pose pose = original.pose();
        return original.withId(id)
                .withPose(pose.withPosition(sum(pose.position(), by)))
                .withMotion(moved(original.motion(), by));
    }

    private static Vector2 sum(Vector2 place, Vector2 by) {
        return Rounding.round(place, place.plus(by));
    }

    private static WaypointPath moved(WaypointPath path, Vector2 by) {
        return path.withWaypoints(
                path.waypoints().stream().map(point -> sum(point, by)).toList());
    }
}
