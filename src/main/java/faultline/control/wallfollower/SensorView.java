package faultline.control.wallfollower;

import faultline.geometry.Vector2;
import faultline.sensor.Reading;

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
