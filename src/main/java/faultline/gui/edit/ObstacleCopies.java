package faultline.gui.edit;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import faultline.world.WaypointPath;
import java.util.Collection;
import java.util.List;
import java.util.stream.IntStream;

/** Copies obstacles. */
public final class ObstacleCopies {

    /** The usual displacement, metres. */
    private static final Vector2 OFFSET = new Vector2(0.2, -0.2);
    /** The displacements that are tried in turn, and then their multiples, metres. */
    private static final List<Vector2> OFFSETS =
            List.of(OFFSET, new Vector2(-0.2, -0.2), new Vector2(0.2, 0.2), new Vector2(-0.2, 0.2));
    /** The greatest multiple of a displacement. */
    private static final int MAX_STEPS = 20;
    /** Centres at less than this distance look the same, metres. */
    private static final double SAME = 0.01;

    private ObstacleCopies() {}

    /**
     * Returns the displacement of copies from their originals, whose centre is given: a little to the right and below,
     * or in another direction if their centre would be outside a room of this width and height, or that of another
     * obstacle.
     */
    public static Vector2 offset(Vector2 centre, double width, double height, Collection<Vector2> others) {
        return IntStream.rangeClosed(1, MAX_STEPS)
                .boxed()
                .flatMap(steps -> OFFSETS.stream().map(offset -> offset.times(steps)))
                .filter(by -> isInside(centre.plus(by), width, height))
                .filter(by -> others.stream().noneMatch(other -> other.distanceTo(centre.plus(by)) < SAME))
                .findFirst()
                .orElse(OFFSET);
    }

    private static boolean isInside(Vector2 place, double width, double height) {
        return place.x() >= 0 && place.x() <= width && place.y() >= 0 && place.y() <= height;
    }

    /**
     * Returns copies with new ids that are not taken, displaced by an offset from the originals, or at the same place
     * if none of the originals still exists.
     */
    public static List<Obstacle> copyOf(List<Obstacle> originals, Collection<String> taken, Vector2 offset) {
        Vector2 by = originals.stream().map(Obstacle::id).anyMatch(taken::contains) ? offset : Vector2.ZERO;
        IdGenerator ids = new IdGenerator(taken);
        return originals.stream()
                .map(original -> moved(original, ids.next(original.id()), by))
                .toList();
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
