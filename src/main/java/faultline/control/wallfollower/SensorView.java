package faultline.control.wallfollower;

import faultline.geometry.Vector2;
import faultline.sensor.Reading;

/**
 * One sensor as the follower sees through it, in a frame in which the wall is kept on the left: where its cone sits,
 * and what it reports now.
 *
 * @param mountPosition the apex, metres ahead and to the left of the robot's centre
 * @param bearing of the axis, radians, counter-clockwise from straight ahead
 * @param halfCone half the field of view, radians
 * @param range metres
 * @param reading the reported distance, metres; positive infinity for nothing, off, or no such sensor
 * @param present whether there is such a sensor and it answers
 */
record SensorView(
        Vector2 mountPosition, double bearing, double halfCone, double range, double reading, boolean present) {

    /** A sensor that is not there. */
    static final SensorView NONE = new SensorView(Vector2.ZERO, 0, 0, 0, Reading.NOTHING, false);

    boolean detects() {
        return reading < Reading.NOTHING;
    }

    /** What is known of the distance to the nearest thing: the reading, or at least the range. */
    double minDistance() {
        return detects() ? reading : range;
    }

    /**
     * The distance from the robot's centre of a long straight wall that would give the reading.
     *
     * @param normal the bearing at which the robot's centre has the wall's foot, radians
     * @return metres; where nothing is seen, the least distance that such a wall would have
     */
    double wallDistance(double normal) {
        // The nearest point in the cone is the foot, or lies on the edge next to it: h = R cos(max(0, |phi| - b)) +
        // mount position . n
        double off = Math.max(0, Math.abs(normal - bearing) - halfCone);
        return minDistance() * StrictMath.cos(off)
                + mountPosition.x() * StrictMath.cos(normal)
                + mountPosition.y() * StrictMath.sin(normal);
    }

    /** The distance from the centre to a wall that the axis meets squarely. */
    double perpendicularDistance() {
        return wallDistance(bearing);
    }

    /** Whether it sees a wall that, if its axis meets it squarely, is within a distance of the robot's centre. */
    boolean detectsWithin(double distance) {
        return detects() && perpendicularDistance() <= distance;
    }
}
