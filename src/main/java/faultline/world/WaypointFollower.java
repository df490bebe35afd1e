package faultline.world;

import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.List;

/** The progress of a moving obstacle along its path; mutable, confined to the simulation thread. */
final class WaypointFollower {

    /**
     * A straight part of the path within a tick, at constant velocity.
     *
     * @param from seconds from the start of the tick
     * @param to seconds from the start of the tick
     * @param start the position at {@code from}
     * @param velocity metres per second
     */
    record Leg(double from, double to, Vector2 start, Vector2 velocity) {}

    /**
     * A waypoint is reached within this distance, metres; otherwise a waypoint at which the obstacle just touches the
     * robot would never be reached.
     */
    private static final double ARRIVAL_TOLERANCE = 1e-9;

    private final WaypointPath path;
    private double x;
    private double y;
    private int nextWaypoint;

    /** Creates a follower at a position, moving to the first waypoint. */
    WaypointFollower(WaypointPath path, Vector2 start) {
        this.path = path;
        x = start.x();
        y = start.y();
    }

    /** Takes over the progress of another follower if the paths are equal except for their speeds. */
    void continueFrom(WaypointFollower other) {
        if (other.path.withSpeed(path.speed()).equals(path)) {
            nextWaypoint = other.nextWaypoint;
        }
    }

    double x() {
        return x;
    }

    double y() {
        return y;
    }

    double speed() {
        return path.speed();
    }

    /** Returns the parts of the path in the next seconds if nothing blocks it. */
    List<Leg> legs(double time) {
        List<Leg> legs = new ArrayList<>();
        WaypointFollower scout = new WaypointFollower(path, new Vector2(x, y));
        scout.nextWaypoint = nextWaypoint;
        scout.travel(time, legs);
        return legs;
    }

    /** Moves along the path for some seconds as if nothing blocked it. */
    void advance(double time) {
        travel(time, null);
    }

    /** Moves along the path, and adds its parts to a list unless that is null. */
    private void travel(double time, List<Leg> legs) {
        List<Vector2> waypoints = path.waypoints();
        double now = 0;
        int stops = 0;
        while (now < time && path.speed() > 0 && nextWaypoint < waypoints.size() && stops <= waypoints.size()) {
            Vector2 target = waypoints.get(nextWaypoint);
            double dx = target.x() - x;
            double dy = target.y() - y;
            double length = Math.sqrt(dx * dx + dy * dy);
            double arrival = now + length / path.speed();
            if (arrival > time) {
                double scale = path.speed() / length;
                addLeg(legs, now, time, scale * dx, scale * dy);
                x += (time - now) * (scale * dx);
                y += (time - now) * (scale * dy);
                now = time;
            } else {
                stops = length > ARRIVAL_TOLERANCE ? 0 : stops + 1;
                if (length > ARRIVAL_TOLERANCE) {
                    double scale = 1 / (arrival - now);
                    addLeg(legs, now, arrival, scale * dx, scale * dy);
                    x = target.x();
                    y = target.y();
                    now = arrival;
                }
                nextWaypoint = path.loop() ? (nextWaypoint + 1) % waypoints.size() : nextWaypoint + 1;
            }
        }
    }

    private void addLeg(List<Leg> legs, double from, double to, double vx, double vy) {
        if (legs != null) {
            legs.add(new Leg(from, to, new Vector2(x, y), new Vector2(vx, vy)));
        }
    }
}
