package faultline.robot;

import faultline.geometry.Degrees;
import faultline.geometry.Vector2;
import faultline.sensor.SensorSpec;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The four-wheel differential-drive robot as it is built and set. Its body is a rectangle about its centre, which is
 * also its centre of rotation; its frame has x ahead and y to the left.
 *
 * @param length of the platform, along x, metres, positive
 * @param width of the platform, along y, metres, positive
 * @param track width between the left and the right wheels, metres, positive
 * @param speed the linear velocity that the controller drives at, metres per second, positive
 * @param turnRate the rate that the controller spins at, radians per second, positive
 * @param motor either side's motor
 * @param sensors in the order of the trace's columns; ids are unique
 */
public record RobotSpec(
        double length,
        double width,
        double track,
        double speed,
        double turnRate,
        MotorSpec motor,
        List<SensorSpec> sensors) {

    /** The robot that is used where a file gives no values. */
    public static final RobotSpec DEFAULT =
            new RobotSpec(0.25, 0.20, 0.18, 0.3, Degrees.toRadians(60), MotorSpec.DEFAULT, standardSensors(0.25, 0.20));

    public RobotSpec {
        requirePositive("length", length);
        requirePositive("width", width);
        requirePositive("track", track);
        requirePositive("speed", speed);
        requirePositive("turn rate", turnRate);
        sensors = List.copyOf(sensors);
        Set<String> ids = new HashSet<>();
        for (SensorSpec sensor : sensors) {
            if (!ids.add(sensor.id())) {
                throw new IllegalArgumentException("two sensors are called " + sensor.id());
            }
        }
    }

    private static void requirePositive(String name, double value) {
        if (!(value > 0 && Double.isFinite(value))) {
            throw new IllegalArgumentException("the robot's " + name + " must be positive: " + value);
        }
    }

    /**
     * The eight standard sensors, symmetric about the robot's axis: at the corners and the middles of the sides.
     *
     * @param length of the platform, metres
     * @param width of the platform, metres
     * @return front, front-left, left, rear-left, rear, rear-right, right, front-right
     */
    public static List<SensorSpec> standardSensors(double length, double width) {
        double x = length / 2;
        double y = width / 2;
        return List.of(
                standardSensor("front", x, 0, 0),
                standardSensor("front-left", x, y, 45),
                standardSensor("left", 0, y, 90),
                standardSensor("rear-left", -x, y, 135),
                standardSensor("rear", -x, 0, 180),
                standardSensor("rear-right", -x, -y, -135),
                standardSensor("right", 0, -y, -90),
                standardSensor("front-right", x, -y, -45));
    }

    private static SensorSpec standardSensor(String id, double x, double y, double bearingDegrees) {
        return new SensorSpec(
                id,
                new Vector2(x, y),
                Degrees.toRadians(bearingDegrees),
                SensorSpec.DEFAULT_RANGE,
                SensorSpec.DEFAULT_CONE,
                true,
                0);
    }

    /**
     * The place of a sensor in the list.
     *
     * @param id the sensor's id
     * @return its index, or -1 where there is none of that id
     */
    public int indexOf(String id) {
        for (int i = 0; i < sensors.size(); i++) {
            if (sensors.get(i).id().equals(id)) {
                return i;
            }
        }
        return -1;
    }

    /**
     * The sensor of an id.
     *
     * @param id the sensor's id
     * @return the sensor, empty where there is none of that id
     */
    public Optional<SensorSpec> sensor(String id) {
        int index = indexOf(id);
        return index < 0 ? Optional.empty() : Optional.of(sensors.get(index));
    }

    /**
     * This robot with one sensor exchanged for another of the same id.
     *
     * @param sensor the new sensor
     * @return the same robot otherwise
     * @throws IllegalArgumentException if no sensor has its id
     */
    public RobotSpec withSensor(SensorSpec sensor) {
        int index = indexOf(sensor.id());
        if (index < 0) {
            throw new IllegalArgumentException("the robot has no sensor " + sensor.id());
        }
        List<SensorSpec> changed = new java.util.ArrayList<>(sensors);
        changed.set(index, sensor);
        return new RobotSpec(length, width, track, speed, turnRate, motor, changed);
    }

    /**
     * This robot with another platform and speed.
     *
     * @param newLength metres
     * @param newWidth metres
     * @param newSpeed metres per second
     * @return the same robot otherwise; the sensors keep their seats
     */
    public RobotSpec withPlatform(double newLength, double newWidth, double newSpeed) {
        return new RobotSpec(newLength, newWidth, track, newSpeed, turnRate, motor, sensors);
    }

    /**
     * The radius of the circle about the centre that the platform turns within.
     *
     * @return metres
     */
    public double boundingRadius() {
        return Math.sqrt(length * length + width * width) / 2;
    }
}
