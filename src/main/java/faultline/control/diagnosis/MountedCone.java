package faultline.control.diagnosis;

import faultline.control.WallSide;
import faultline.geometry.Angles;
import faultline.sensor.SensorSpec;

/**
 * The pose and size of a sensor's cone in a frame in which the wall is on the left.
 *
 * @param x the apex, metres ahead of the robot's centre
 * @param y the apex, metres to the left of it
 * @param bearing the bearing of the axis, radians, counter-clockwise from straight ahead, in (-pi, pi]
 * @param half half the field of view, radians
 * @param range metres
 */
public record MountedCone(double x, double y, double bearing, double half, double range) {

    /** The least angle between straight ahead and a cone that looks diagonally ahead, radians. */
    private static final double MIN_ASIDE = 0.2;

    /** The bearing of a cone that looks diagonally ahead is less than this, radians. */
    private static final double MAX_DIAGONAL = 1.2;

    static MountedCone of(SensorSpec sensor, WallSide side) {
        return new MountedCone(
                sensor.mountPosition().x(),
                side.sign() * sensor.mountPosition().y(),
                Angles.normalize(side.sign() * sensor.bearing()),
                sensor.cone() / 2,
                sensor.range());
    }

    /** Returns whether straight ahead is inside the cone. */
    boolean looksAhead() {
        return Math.abs(bearing) < half;
    }

    /** Returns whether straight ahead is outside the cone; false as well if it is on the cone's border. */
    boolean looksAside() {
        return Math.abs(bearing) > half;
    }

    /** Returns whether the cone looks diagonally ahead, on either side. */
    boolean looksDiagonally() {
        return Math.abs(bearing) > half + MIN_ASIDE && Math.abs(bearing) < MAX_DIAGONAL;
    }

    /** Returns the range as far as it is certainly within a distance of the robot's centre, metres. */
    double rangeWithin(double distance) {
        return Math.min(range, distance - Math.sqrt(x * x + y * y));
    }
}
