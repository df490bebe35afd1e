package faultline.control.wallfollower;

import faultline.control.Observation;
import faultline.control.WallSide;
import faultline.geometry.Angles;
import faultline.geometry.Vector2;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.util.List;

/**
 * One sensor in the follower's frame, in which the wall is on the left: the pose of its cone, and its current reading.
 *
 * @param mountPosition the apex, metres ahead and to the left of the robot's centre
 * @param bearing the bearing of the axis, radians, counter-clockwise from straight ahead
 * @param halfCone half the field of view, radians
 * @param range metres
 * @param reading the reported distance, metres; positive infinity for nothing, off, or no such sensor
 * @param present whether the sensor exists and answers
 */
record SensorView(
        Vector2 mountPosition, double bearing, double halfCone, double range, double reading, boolean present) {

    /** A sensor that does not exist. */
    static final SensorView NONE = new SensorView(Vector2.ZERO, 0, 0, 0, Reading.NOTHING, false);

    /** A sensor looks in a direction if its bearing differs by at most this. */
    private static final double BEARING_TOLERANCE = StrictMath.toRadians(20);

    /**
     * Returns the sensor that looks in a direction, found by its bearing and not by its name. A follower with the wall
     * on the right is the mirror image of one with the wall on the left.
     *
     * @param bearing the direction, radians, in a frame in which the wall is on the left
     * @param observation the observation
     * @param wallSide the side of the wall
     * @return {@link #NONE} if no sensor that answers looks there
     */
    static SensorView facing(double bearing, Observation observation, WallSide wallSide) {
        double side = wallSide == WallSide.LEFT ? 1 : -1;
        List<SensorSpec> sensors = observation.robot().sensors();
        int best = -1;
        double least = BEARING_TOLERANCE;
        for (int i = 0; i < sensors.size(); i++) {
            double off =
                    Math.abs(Angles.difference(bearing, side * sensors.get(i).bearing()));
            if (off < least && !Reading.isOff(observation.readings()[i])) {
                best = i;
                least = off;
            }
        }
        return best < 0 ? NONE : of(sensors.get(best), observation.readings()[best], side);
    }

    private static SensorView of(SensorSpec sensor, double reading, double side) {
        Vector2 mountPosition = new Vector2(
                sensor.mountPosition().x(), side * sensor.mountPosition().y());
        return new SensorView(
                mountPosition,
                Angles.normalize(side * sensor.bearing()),
                sensor.cone() / 2,
                sensor.range(),
                reading,
                true);
    }

    /** Returns the same sensor with another reading. */
    SensorView withReading(double other) {
        return new SensorView(mountPosition, bearing, halfCone, range, other, present);
    }

    boolean detects() {
        return reading < Reading.NOTHING;
    }

    /** Returns the least possible distance of the nearest object: the reading, or the range if there is none. */
    double minDistance() {
        return detects() ? reading : range;
    }

    /**
     * Returns the distance from the robot's centre of a long straight wall that would give the reading.
     *
     * @param normal the bearing of the wall's foot from the robot's centre, radians
     * @return metres; if nothing is seen, the least distance that such a wall would have
     */
    double wallDistance(double normal) {
        // The nearest point in the cone is the foot, or lies on the edge next to it: h = R cos(max(0, |phi| - b)) +
        // mount position . n
        double off = Math.max(0, Math.abs(normal - bearing) - halfCone);
        return minDistance() * StrictMath.cos(off)
                + mountPosition.x() * StrictMath.cos(normal)
                + mountPosition.y() * StrictMath.sin(normal);
    }

    /** Returns the distance from the centre to a wall that the axis meets at a right angle. */
    double perpendicularDistance() {
        return wallDistance(bearing);
    }

    /**
     * Returns whether it sees a wall that, if its axis meets it at a right angle, is within a distance of the robot's
     * centre.
     */
    boolean detectsWithin(double distance) {
        return detects() && perpendicularDistance() <= distance;
    }
}
