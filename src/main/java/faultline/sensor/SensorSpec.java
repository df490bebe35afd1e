package faultline.sensor;

import faultline.geometry.Degrees;
import faultline.geometry.Vector2;

/**
 * The mounting and settings of one infrared cone sensor, within {@link SensorLimits}.
 *
 * @param id the sensor's name, unique on the robot
 * @param mountPosition the apex of its cone in the robot's frame, metres ahead (x) and to the left (y) of the robot's
 *     centre
 * @param bearing the direction of its axis in the robot's frame, radians, counter-clockwise from straight ahead
 * @param range the greatest distance that it measures, metres
 * @param cone its field of view, the full angle of the cone, radians
 * @param on whether it is switched on
 * @param noise the standard deviation of its Gaussian noise, metres, 0 for none
 */
public record SensorSpec(
        String id, Vector2 mountPosition, double bearing, double range, double cone, boolean on, double noise) {

    /** The range if none is given, metres. */
    public static final double DEFAULT_RANGE = 0.8;

    /** The cone if none is given, 20 degrees. */
    public static final double DEFAULT_CONE = Degrees.toRadians(20);

    /**
     * Creates a sensor.
     *
     * @param id the sensor's name, unique on the robot
     * @param mountPosition the apex of its cone in the robot's frame, metres ahead (x) and to the left (y) of the
     *     robot's centre
     * @param bearing the direction of its axis in the robot's frame, radians, counter-clockwise from straight ahead
     * @param range the greatest distance that it measures, metres
     * @param cone its field of view, the full angle of the cone, radians
     * @param on whether it is switched on
     * @param noise the standard deviation of its Gaussian noise, metres, 0 for none
     * @throws IllegalArgumentException if the id is empty, the mounting position or bearing is not finite, or another
     *     value is outside its {@linkplain SensorLimits limits}
     */
    public SensorSpec {
        require(!id.isEmpty(), "a sensor needs an id");
        require(
                mountPosition.isFinite() && Double.isFinite(bearing),
                id + ": mounting position and bearing must be finite");
        requireWithin(id, "range", range, SensorLimits.MIN_RANGE, SensorLimits.MAX_RANGE);
        require(cone > 0 && cone < SensorLimits.MAX_CONE, id + ": cone must be more than 0 and less than pi: " + cone);
        requireWithin(id, "noise", noise, 0, SensorLimits.MAX_NOISE);
    }

    private static void requireWithin(String id, String name, double value, double min, double max) {
        require(value >= min && value <= max, id + ": " + name + " must be from " + min + " to " + max + ": " + value);
    }

    private static void require(boolean condition, String message) {
        if (!condition) {
            throw new IllegalArgumentException(message);
        }
    }

    /**
     * {@return this sensor with another id}
     *
     * @param newId the id, not empty
     * @throws IllegalArgumentException if the id is empty
     */
    public SensorSpec withId(String newId) {
        return new SensorSpec(newId, mountPosition, bearing, range, cone, on, noise);
    }

    /**
     * {@return this sensor switched on or off}
     *
     * @param newOn whether the sensor is on
     */
    public SensorSpec withOn(boolean newOn) {
        return new SensorSpec(id, mountPosition, bearing, range, cone, newOn, noise);
    }

    /**
     * {@return this sensor with another range, metres}
     *
     * @param newRange the range, in metres, from {@link SensorLimits#MIN_RANGE} to {@link SensorLimits#MAX_RANGE}
     * @throws IllegalArgumentException if the range is outside its limits
     */
    public SensorSpec withRange(double newRange) {
        return new SensorSpec(id, mountPosition, bearing, newRange, cone, on, noise);
    }

    /**
     * {@return this sensor with another field of view, radians}
     *
     * @param newCone the field of view, in radians, in (0, pi)
     * @throws IllegalArgumentException if the field of view is outside its limits
     */
    public SensorSpec withCone(double newCone) {
        return new SensorSpec(id, mountPosition, bearing, range, newCone, on, noise);
    }

    /**
     * {@return this sensor at another mounting position in the robot's frame}
     *
     * @param newPosition the mounting position, in metres ahead (x) and to the left (y) of the robot's centre
     * @throws IllegalArgumentException if a coordinate is not finite
     */
    public SensorSpec withMountPosition(Vector2 newPosition) {
        return new SensorSpec(id, newPosition, bearing, range, cone, on, noise);
    }

    /**
     * {@return this sensor with another bearing, radians}
     *
     * @param newBearing the bearing, in radians, positive to the left
     * @throws IllegalArgumentException if the bearing is not finite
     */
    public SensorSpec withBearing(double newBearing) {
        return new SensorSpec(id, mountPosition, newBearing, range, cone, on, noise);
    }

    /**
     * {@return this sensor with another standard deviation of its noise, metres}
     *
     * @param newNoise the standard deviation, in metres, from 0 to {@link SensorLimits#MAX_NOISE}
     * @throws IllegalArgumentException if the standard deviation is outside its limits
     */
    public SensorSpec withNoise(double newNoise) {
        return new SensorSpec(id, mountPosition, bearing, range, cone, on, newNoise);
    }
}
