package faultline.world;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.List;

/** How far a moving obstacle has come on its way; mutable, on the world's thread. */
final class WaypointFollower {

    /**
     * A straight piece of a tick's way: from a time to a time within the tick, at constant velocity, starting at a
     * place.
     */
    record Leg(double from, double to, Vector2 start, Vector2 velocity) {}

    /**
     * A way-point counts as reached from here, metres: one where the mover just touches the robot would never be
     * reached otherwise.
     */
    private static final double ARRIVAL_TOLERANCE = 1e-9;

    private final WaypointPath path;
    private Vector2 position;
    private int nextWaypoint;

    /** A mover that sets out from where its obstacle stands towards the first way-point. */
    WaypointFollower(WaypointPath motion, Vector2 start) {
        this.path = motion;
        this.position = start;
    }

    /**
     * What this one becomes when its obstacle is exchanged: on the same way, at whatever speed, it goes on to the same
     * way-point.
     */
    WaypointFollower replacedBy(WaypointFollower other) {
        if (path.withSpeed(other.path.speed()).equals(other.path)) {
            other.nextWaypoint = nextWaypoint;
        }
        return other;
    }

    Vector2 position() {
        return position;
    }

    /** The pieces of the way that a tick holds if nothing is in it. */
    List<Leg> legs(double dt) {
        return travel(dt, false);
    }

    /** Goes on along the way for a time, as if nothing were in it. */
    void advance(double time) {
        travel(time, true);
    }

    private List<Leg> travel(double time, boolean keep) {
        List<Leg> legs = new ArrayList<>();
        Vector2 at = position;
        int target = nextWaypoint;
        double now = 0;
        int stops = 0;
        while (now < time
                && path.speed() > 0
                && target < path.waypoints().size()
                && stops <= path.waypoints().size()) {
            Vector2 way = path.waypoints().get(target).minus(at);
            double length = way.length();
            double arrival = now + length / path.speed();
            if (arrival > time) {
                Vector2 velocity = way.times(path.speed() / length);
                legs.add(new Leg(now, time, at, velocity));
                at = at.plus(velocity.times(time - now));
                now = time;
            } else {
                stops = length > ARRIVAL_TOLERANCE ? 0 : stops + 1;
                if (length > ARRIVAL_TOLERANCE) {
                    legs.add(new Leg(now, arrival, at, way.times(1 / (arrival - now))));
                    at = path.waypoints().get(target);
                    now = arrival;
                }
                target = path.loop() ? (target + 1) % path.waypoints().size() : target + 1;
            }
        }
        if (keep) {
            position = at;
            nextWaypoint = target;
        }
        return legs;
    }

    /** Puts the mover somewhere else; it goes on to the way-point that it was going to. */
    void moveTo(Pose pose) {
        position = pose.position();
    }
}
