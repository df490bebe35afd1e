package faultline.control.wallfollower;

import faultline.geometry.Vector2;
import faultline.sensor.Reading;

/**
 * Remembers the nearest object that may have left the cone of a sensor at one of its edges. It is then in the blind
 * spot between two cones, where the robot may still run into it. Dead reckoning follows it until the robot has passed
 * it.
 *
 * <p>An object leaves the cone at the edge at which the robot's motion carries it outwards. While it is seen, it may be
 * anywhere on its arc, so it is taken to be at that edge.
 */
final class BlindSpotMemory {

    /** A turn of more than this makes the place of an object uncertain, radians. */
    private static final double MAX_TURN = StrictMath.PI / 2;

    /** If the next cone begins within this angle of an edge, there is no blind spot, radians. */
    private static final double MIN_GAP = StrictMath.toRadians(10);

    private final TrackedPlace left = new TrackedPlace();
    private final TrackedPlace right = new TrackedPlace();

    /** A place in the robot's frame, metres ahead and to the left of the robot's centre. */
    private static final class TrackedPlace {
        private double x = Reading.NOTHING;
        private double y;
        private double accumulatedTurn;

        boolean exists() {
            return x < Reading.NOTHING;
        }

        void clear() {
            x = Reading.NOTHING;
        }

        void advance(double rolled, double turn) {
            if (!exists()) {
                return;
            }
            double ahead = x - rolled;
            x = ahead + turn * y;
            y -= turn * ahead;
            accumulatedTurn += Math.abs(turn);
            if (x < 0 || accumulatedTurn > MAX_TURN) {
                clear();
            }
        }

        /** Replaces the place if the new one is nearer. */
        void set(Vector2 place) {
            if (place.length() <= distanceAfter(0)) {
                x = place.x();
                y = place.y();
                accumulatedTurn = 0;
            }
        }

        double distanceAfter(double rolled) {
            return exists() ? StrictMath.hypot(x - rolled, y) : Reading.NOTHING;
        }
    }

    /**
     * Processes a reading after some motion, which is small.
     *
     * @param sensor the sensor
     * @param toTheLeft the next sensor to the left, {@link SensorView#NONE} if there is none
     * @param toTheRight the next sensor to the right
     * @param wallOnTheLeft whether it sees a long wall on the left, which does not leave the cone at the right edge
     * @param rolled the distance rolled, metres
     * @param turn the turn, radians
     */
    void update(
            SensorView sensor,
            SensorView toTheLeft,
            SensorView toTheRight,
            boolean wallOnTheLeft,
            double rolled,
            double turn) {
        left.advance(rolled, turn);
        right.advance(rolled, turn);
        if (sensor.detects()) {
            place(left, sensor, toTheLeft, sensor.halfCone(), rolled, turn);
            if (!wallOnTheLeft) {
                place(right, sensor, toTheRight, -sensor.halfCone(), rolled, turn);
            }
        }
    }

    /** Places the object at an edge if the motion carries it outwards there, into a blind spot. */
    private static void place(
            TrackedPlace target, SensorView sensor, SensorView next, double edge, double rolled, double turn) {
        double gap = Math.abs(next.bearing() - sensor.bearing() - edge) - next.halfCone();
        if (next.present() && gap < MIN_GAP) {
            return;
        }
        Vector2 fromMount = Vector2.direction(sensor.bearing() + edge).times(sensor.reading());
        Vector2 place = sensor.mountPosition().plus(fromMount);
        Vector2 motion = new Vector2(turn * place.y() - rolled, -turn * place.x());
        if (fromMount.cross(motion) * edge > 0) {
            target.set(place);
        }
    }

    /** Forgets what was seen. */
    void clear() {
        left.clear();
        right.clear();
    }

    /**
     * Returns the distance of the nearest object that is remembered from the robot's centre after some more straight
     * motion.
     *
     * @param rolled metres
     * @return metres; infinite if there is none
     */
    double distanceAfter(double rolled) {
        return Math.min(left.distanceAfter(rolled), right.distanceAfter(rolled));
    }
}
