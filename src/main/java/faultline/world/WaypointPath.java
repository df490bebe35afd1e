package faultline.world;

import faultline.geometry.Vector2;
import java.util.List;

/**
 * How an obstacle moves: from where it stands to the first way-point, then from each to the next, at constant speed and
 * without turning.
 *
 * @param speed metres per second, not negative
 * @param loop whether the last way-point is followed by the first again, or the obstacle stays there
 * @param waypoints the way-points of the shape's origin, in the world, at least one
 */
public record WaypointPath(double speed, boolean loop, List<Vector2> waypoints) {

    public WaypointPath {
        if (!(speed >= 0 && Double.isFinite(speed))) {
            throw new IllegalArgumentException("an obstacle's speed must not be negative: " + speed);
        }
        waypoints = List.copyOf(waypoints);
        if (waypoints.isEmpty() || !waypoints.stream().allMatch(Vector2::isFinite)) {
            throw new IllegalArgumentException("a motion needs way-points, all finite: " + waypoints);
        }
    }

    /**
     * The same way at another speed.
     *
     * @param other metres per second, not negative
     * @return the same motion otherwise
     */
    public WaypointPath withSpeed(double other) {
        return new WaypointPath(other, loop, waypoints);
    }
}
