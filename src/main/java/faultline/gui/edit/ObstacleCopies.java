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

/** Copies of obstacles beside their originals, with ids of their own. */
public final class ObstacleCopies {

    private static final Vector2 OFFSET = new Vector2(0.2, -0.2);

    private ObstacleCopies() {}

    /**
     * Copies.
     *
     * @param originals what is copied
     * @param taken the ids that are taken
     * @return one for each original: a little to the right and below, unless none of the originals is there any more
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

    private static Obstacle moved(Obstacle original, String id, Vector2 by) {
        Pose pose = original.pose();
        return original.withId(id)
                .withPose(pose.withPosition(Rounding.round(pose.position().plus(by))))
                .withMotion(moved(original.motion(), by));
    }

    private static WaypointPath moved(WaypointPath way, Vector2 by) {
        return way.withWaypoints(way.waypoints().stream()
                .map(point -> Rounding.round(point.plus(by)))
                .toList());
    }
}
