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

    /**
     * The shortest time in which an obstacle of a scenario file may visit all waypoints of a loop, seconds; otherwise
     * one tick could hold millions of legs.
     */
    public static final double MIN_LOOP_TIME = 0.01;

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

    /** {@return the length of the closed path through all waypoints, metres} */
    public double loopLength() {
        double length = 0;
        for (int i = 0; i < waypoints.size(); i++) {
            length += waypoints.get(i).distanceTo(waypoints.get((i + 1) % waypoints.size()));
        }
        return length;
    }

    /** {@return whether this is a loop that takes less than {@link #MIN_LOOP_TIME}, but not one that stays in place} */
    public boolean isLoopTooShort() {
        double length = loop ? loopLength() : 0;
        return length > 0 && length < speed * MIN_LOOP_TIME;
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
