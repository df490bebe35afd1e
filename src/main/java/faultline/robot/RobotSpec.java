package faultline.robot;

import faultline.geometry.Degrees;
import faultline.geometry.Vector2;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The construction and settings of the four-wheel differential-drive robot. Its body is a rectangle about its centre,
 * which is also its centre of rotation; its frame has x ahead and y to the left.
 *
 * @param length the length of the platform, along x, metres, positive
 * @param width the width of the platform, along y, metres, positive
 * @param track the distance between the left and the right wheels, metres, positive
 * @param speed the linear velocity that the controller drives at, metres per second, positive
 * @param turnRate the angular velocity that the controller turns on the spot at, radians per second, positive
 * @param motor the motor of either side, as the controller believes it to be
 * @param driveScale the true wheels and track relative to the model of the controller
 * @param sensors the sensors, in the order of the trace's columns; ids are unique
 */
public record RobotSpec(
        double length,
        double width,
        double track,
        double speed,
        double turnRate,
        MotorSpec motor,
        DriveScale driveScale,
        List<SensorSpec> sensors) {

    /** The robot of a scenario that gives no values. */
    public static final RobotSpec DEFAULT = new RobotSpec(
            0.25,
            0.20,
            0.18,
            0.3,
            Degrees.toRadians(60),
            MotorSpec.DEFAULT,
            DriveScale.NONE,
            standardSensors(0.25, 0.20));

    /**
     * Creates a robot.
     *
     * @param length the length of the platform, along x, metres, positive
     * @param width the width of the platform, along y, metres, positive
     * @param track the distance between the left and the right wheels, metres, positive
     * @param speed the linear velocity that the controller drives at, metres per second, positive
     * @param turnRate the angular velocity that the controller turns on the spot at, radians per second, positive
     * @param motor the motor of either side, as the controller believes it to be
     * @param driveScale the true wheels and track relative to the model of the controller
     * @param sensors the sensors, in the order of the trace's columns; ids are unique
     * @throws IllegalArgumentException if a length or speed is not positive and finite, or two sensors have the same id
     */
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
                throw new IllegalArgumentException("two sensors have the id " + sensor.id());
            }
        }
    }

    private static void requirePositive(String name, double value) {
        if (!(value > 0 && Double.isFinite(value))) {
            throw new IllegalArgumentException("the robot's " + name + " must be positive: " + value);
        }
    }

    /**
     * {@return the eight standard sensors, symmetric about the robot's axis, at the corners and the middles of the
     * sides: front, front-left, left, rear-left, rear, rear-right, right, front-right}
     *
     * @param length the length of the platform, metres
     * @param width the width of the platform, metres
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

    /** {@return the ids of the sensors, in their order} */
    public List<String> sensorIds() {
        return sensors.stream().map(SensorSpec::id).toList();
    }

    /**
     * {@return the index of the sensor with an id, or -1 if there is none}
     *
     * @param id the sensor's id
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
     * {@return the sensor with an id}
     *
     * @param id the sensor's id
     */
    public Optional<SensorSpec> sensor(String id) {
        int index = indexOf(id);
        return index < 0 ? Optional.empty() : Optional.of(sensors.get(index));
    }

    /**
     * {@return this robot with one sensor replaced by another with the same id}
     *
     * @param sensor the new sensor
     * @throws IllegalArgumentException if no sensor has that id
     */
    public RobotSpec withSensor(SensorSpec sensor) {
        int index = indexOf(sensor.id());
        if (index < 0) {
            throw new IllegalArgumentException("the robot has no sensor " + sensor.id());
        }
        List<SensorSpec> changed = new ArrayList<>(sensors);
        changed.set(index, sensor);
        return withSensors(changed);
    }

    /**
     * {@return this robot with other sensors}
     *
     * @param newSensors the new sensors, with different ids
     */
    public RobotSpec withSensors(List<SensorSpec> newSensors) {
        return new RobotSpec(length, width, track, speed, turnRate, motor, driveScale, newSensors);
    }

    /**
     * {@return this robot with another platform and linear velocity; the sensors keep their mounting positions}
     *
     * @param newLength the length of the platform, in metres, positive
     * @param newWidth the width of the platform, in metres, positive
     * @param newSpeed the linear velocity, in metres per second, positive
     */
    public RobotSpec withPlatform(double newLength, double newWidth, double newSpeed) {
        return new RobotSpec(newLength, newWidth, track, newSpeed, turnRate, motor, driveScale, sensors);
    }

    /**
     * {@return this robot with another linear velocity, metres per second}
     *
     * @param newSpeed the linear velocity, in metres per second, positive
     */
    public RobotSpec withSpeed(double newSpeed) {
        return withPlatform(length, width, newSpeed);
    }

    /**
     * {@return this robot with another turn rate, radians per second}
     *
     * @param newTurnRate the turn rate, in radians per second, positive
     */
    public RobotSpec withTurnRate(double newTurnRate) {
        return new RobotSpec(length, width, track, speed, newTurnRate, motor, driveScale, sensors);
    }

    /**
     * {@return this robot with another motor}
     *
     * @param newMotor the new motor
     */
    public RobotSpec withMotor(MotorSpec newMotor) {
        return new RobotSpec(length, width, track, speed, turnRate, newMotor, driveScale, sensors);
    }

    /**
     * {@return this robot with a drive that differs from what the controller believes}
     *
     * @param newDriveScale the true drive as factors of the believed one
     */
    public RobotSpec withDriveScale(DriveScale newDriveScale) {
        return new RobotSpec(length, width, track, speed, turnRate, motor, newDriveScale, sensors);
    }

    /** {@return this robot as the controller believes it to be: with a drive scale of 1} */
    public RobotSpec believed() {
        return driveScale.isNone() ? this : withDriveScale(DriveScale.NONE);
    }

    /** {@return the fastest turn on the spot that the motors allow, as the controller believes, radians per second} */
    public double maxTurnRate() {
        return 2 * motor.maxSpeed() / track;
    }

    /** {@return the angular velocity of a turn on the spot: the turn rate, or less if the motors allow no more} */
    public double spinRate() {
        return Math.min(turnRate, maxTurnRate());
    }

    /** {@return the true distance between the left and the right wheels, metres} */
    public double trueTrack() {
        return track * driveScale.track();
    }

    /** {@return the radius of the circle about the centre that encloses the platform, metres} */
    public double boundingRadius() {
        return Math.sqrt(length * length + width * width) / 2;
    }
}
