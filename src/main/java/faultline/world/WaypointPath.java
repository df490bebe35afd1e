package faultline.world;

import faultline.geometry.Vector2;
import java.util.List;

/**
 * The motion of an obstacle: from its pose to the first waypoint, then from each waypoint to the next, at constant
 * speed and without rotation.
 *
 * @param speed metres per second, not negative
 * @param loop whether the first waypoint follows the last again; if not, the obstacle stops at the last
 * @param waypoints the positions of the shape's origin, in the world; empty only in {@link #NONE}
 */
public record WaypointPath(double speed, boolean loop, List<Vector2> waypoints) {

    /** The path of a static obstacle. */
    public static final WaypointPath NONE = new WaypointPath(0, false, List.of());

    /**
     * Creates a path.
     *
     * @param speed metres per second, not negative
     * @param loop whether the first waypoint follows the last again; if not, the obstacle stops at the last
     * @param waypoints the positions of the shape's origin, in the world; empty only in {@link #NONE}
     * @throws IllegalArgumentException if the speed is negative or not finite, or there is a speed without waypoints,
     *     or a waypoint is not finite
     */
    public WaypointPath {
        if (!(speed >= 0 && Double.isFinite(speed))) {
            throw new IllegalArgumentException("an obstacle's speed must not be negative: " + speed);
        }
        waypoints = List.copyOf(waypoints);
        boolean none = waypoints.isEmpty() && speed == 0 && !loop;
        if (!none && (waypoints.isEmpty() || !waypoints.stream().allMatch(Vector2::isFinite))) {
            throw new IllegalArgumentException("a motion needs waypoints, all finite: " + waypoints);
        }
    }

    /**
     * {@return this path at another speed, metres per second}
     *
     * @param newSpeed the speed, in metres per second, not negative
     */
    public WaypointPath withSpeed(double newSpeed) {
        return new WaypointPath(newSpeed, loop, waypoints);
    }

    /**
     * {@return this path with other waypoints}
     *
     * @param newWaypoints the waypoints, in metres
     */
    public WaypointPath withWaypoints(List<Vector2> newWaypoints) {
        return new WaypointPath(speed, loop, newWaypoints);
    }
}
