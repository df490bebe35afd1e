package faultline.world;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import java.util.ArrayList;
import java.util.List;

/** How far a moving obstacle has come on its way; mutable, on the world's thread. */
final class Mover {

    /** A straight piece of a tick's way: from a time to a time within the tick, at constant velocity, starting at a place. */
    record Leg(double from, double to, Vec start, Vec velocity) {
    }

    /** A way-point counts as reached from here, metres: one where the mover just touches the robot would never be reached otherwise. */
    private static final double REACHED = 1e-9;

    private final Motion motion;
    private Vec place;
    private int next;

    /** A mover that sets out from where its obstacle stands towards the first way-point. */
    Mover(Motion motion, Vec start) {
        this.motion = motion;
        this.place = start;
    }

    /** What this one becomes when its obstacle is exchanged: on the same way, at whatever speed, it goes on to the same way-point. */
    Mover exchanged(Mover other) {
        if (motion.at(other.motion.speed()).equals(other.motion)) {
            other.next = next;
        }
        return other;
    }

    Vec place() {
        return place;
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
        Vec at = place;
        int target = next;
        double now = 0;
        int stops = 0;
        while (now < time && motion.speed() > 0 && target < motion.points().size() && stops <= motion.points().size()) {
            Vec way = motion.points().get(target).minus(at);
            double length = way.length();
            double arrival = now + length / motion.speed();
            if (arrival > time) {
                Vec velocity = way.times(motion.speed() / length);
                legs.add(new Leg(now, time, at, velocity));
                at = at.plus(velocity.times(time - now));
                now = time;
            } else {
                stops = length > REACHED ? 0 : stops + 1;
                if (length > REACHED) {
                    legs.add(new Leg(now, arrival, at, way.times(1 / (arrival - now))));
                    at = motion.points().get(target);
                    now = arrival;
                }
                target = motion.loop() ? (target + 1) % motion.points().size() : target + 1;
            }
        }
        if (keep) {
            place = at;
            next = target;
        }
        return legs;
    }

    /** Puts the mover somewhere else; it goes on to the way-point that it was going to. */
    void moveTo(Pose pose) {
        place = pose.position();
    }
}
