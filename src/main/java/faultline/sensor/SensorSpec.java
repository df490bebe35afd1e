package faultline.sensor;

import faultline.geometry.Degrees;
import faultline.geometry.Vector2;

/**
 * How one infrared cone sensor is mounted and set.
 *
 * @param id the sensor's name, unique on the robot
 * @param mountPosition the apex of its cone in the robot's frame, metres ahead (x) and to the left (y) of the robot's
 *     centre
 * @param bearing the direction of its axis in the robot's frame, radians, counter-clockwise from straight ahead
 * @param range the farthest distance that it sees, metres, positive
 * @param cone its field of view, the full angle of the cone, radians in (0, pi)
 * @param on whether it is switched on
 * @param noise the standard deviation of its Gaussian noise, metres, 0 for none
 */
public record SensorSpec(
        String id, Vector2 mountPosition, double bearing, double range, double cone, boolean on, double noise) {

    /** The range of a sensor that is given none, metres. */
    public static final double DEFAULT_RANGE = 0.8;

    /** The cone of a sensor that is given none, 20 degrees. */
    public static final double DEFAULT_CONE = Degrees.toRadians(20);

    public SensorSpec {
        require(!id.isEmpty(), "a sensor needs an id");
        require(mountPosition.isFinite() && Double.isFinite(bearing), id + ": seat and bearing must be finite");
        require(range > 0 && Double.isFinite(range), id + ": range must be positive: " + range);
        require(cone > 0 && cone < StrictMath.PI, id + ": cone must be more than 0 and less than pi: " + cone);
        require(noise >= 0 && Double.isFinite(noise), id + ": noise must not be negative: " + noise);
    }

    private static void require(boolean condition, String complaint) {
        if (!condition) {
            throw new IllegalArgumentException(complaint);
        }
    }

    /**
     * This sensor switched.
     *
     * @param nowOn whether it is on
     * @return the same sensor, switched
     */
    public SensorSpec withOn(boolean nowOn) {
        return new SensorSpec(id, mountPosition, bearing, range, cone, nowOn, noise);
    }

    /**
     * This sensor with another range.
     *
     * @param metres the new range, positive
     * @return the same sensor otherwise
     */
    public SensorSpec withRange(double metres) {
        return new SensorSpec(id, mountPosition, bearing, metres, cone, on, noise);
    }

    /**
     * This sensor with another field of view.
     *
     * @param radians the new full angle, in (0, pi)
     * @return the same sensor otherwise
     */
    public SensorSpec withCone(double radians) {
        return new SensorSpec(id, mountPosition, bearing, range, radians, on, noise);
    }

    /**
     * This sensor mounted elsewhere.
     *
     * @param metres the new apex of its cone in the robot's frame
     * @return the same sensor otherwise
     */
    public SensorSpec withMountPosition(Vector2 metres) {
        return new SensorSpec(id, metres, bearing, range, cone, on, noise);
    }

    /**
     * This sensor looking elsewhere.
     *
     * @param radians the new direction of its axis, counter-clockwise from straight ahead
     * @return the same sensor otherwise
     */
    public SensorSpec withBearing(double radians) {
        return new SensorSpec(id, mountPosition, radians, range, cone, on, noise);
    }

    /**
     * This sensor with other noise.
     *
     * @param metres the new standard deviation, not negative
     * @return the same sensor otherwise
     */
    public SensorSpec withNoise(double metres) {
        return new SensorSpec(id, mountPosition, bearing, range, cone, on, metres);
    }
}
