package faultline.gui.edit;

import faultline.geometry.Angles;
import faultline.geometry.Degrees;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import java.util.Comparator;
import java.util.Optional;
import java.util.stream.IntStream;

/** Chooses ids, places and directions of new sensors of a robot. */
final class NewSensors {

    /** The first part of ids, which the number of the sensor follows. */
    private static final String ID_STEM = "sensor-";

    private static final double FULL_CIRCLE = 2 * Math.PI;
    /** Bearings of new sensors are multiples of this, degrees. */
    private static final double BEARING_STEP = 0.5;
    /** Mounting points at less than this distance look the same, metres. */
    private static final double SAME_PLACE = 0.01;
    /** Bearings that differ by less than this look the same, radians. */
    private static final double SAME_BEARING = Degrees.toRadians(1);
    /** Gaps that differ by less than this have the same width, radians. */
    private static final double MAX_ERROR = 1e-9;

    private final RobotSpec robot;

    NewSensors(RobotSpec robot) {
        this.robot = robot;
    }

    /**
     * Returns a sensor at the edge of the platform that faces a direction, radians from straight ahead. Its range, cone
     * and noise are those of the sensor that is nearest in direction.
     */
    SensorSpec facing(double direction) {
        double bearing = roundBearing(direction);
        Optional<SensorSpec> nearest = robot.sensors().stream()
                .min(Comparator.comparingDouble(sensor -> angleBetween(sensor.bearing(), bearing)));
        return new SensorSpec(
                IdGenerator.uniqueId(ID_STEM + (robot.sensors().size() + 1), robot.sensorIds()),
                edgePoint(bearing),
                bearing,
                nearest.map(SensorSpec::range).orElse(SensorSpec.DEFAULT_RANGE),
                nearest.map(SensorSpec::cone).orElse(SensorSpec.DEFAULT_CONE),
                true,
                nearest.map(SensorSpec::noise).orElse(0.0));
    }

    /** Returns where the platform ends in a direction, radians from straight ahead, seen from its centre. */
    private Vector2 edgePoint(double direction) {
        Vector2 axis = Vector2.direction(direction);
        return Rounding.round(
                axis.times(Math.min(robot.length() / 2 / Math.abs(axis.x()), robot.width() / 2 / Math.abs(axis.y()))));
    }

    private static double roundBearing(double radians) {
        return Rounding.roundAngle(Angles.normalize(radians), BEARING_STEP);
    }

    private static double angleBetween(double bearing, double other) {
        return Math.abs(Angles.difference(bearing, other));
    }

    /** Returns a sensor that faces the middle of the {@linkplain #widestGap widest gap}. */
    SensorSpec inWidestGap() {
        return facing(widestGap());
    }

    /**
     * Returns the middle of the widest gap between the directions of the sensors, radians: of several, the first one
     * counter-clockwise from straight ahead; straight ahead if there is no sensor.
     */
    private double widestGap() {
        double[] bearings = robot.sensors().stream()
                .mapToDouble(SensorSpec::bearing)
                .map(bearing -> bearing - FULL_CIRCLE * Math.floor(bearing / FULL_CIRCLE))
                .sorted()
                .toArray();
        double middle = 0;
        double widest = 0;
        for (int i = 0; i < bearings.length; i++) {
            double next = i + 1 < bearings.length ? bearings[i + 1] : bearings[0] + FULL_CIRCLE;
            if (next - bearings[i] > widest + MAX_ERROR) {
                widest = next - bearings[i];
                middle = bearings[i] + widest / 2;
            }
        }
        return middle;
    }

    /** Returns a copy of a sensor, turned to the left by its cone until no sensor at its place faces that direction. */
    SensorSpec copyOf(SensorSpec original) {
        SensorSpec copy = original.withId(IdGenerator.uniqueId(original.id(), robot.sensorIds()));
        return IntStream.rangeClosed(1, robot.sensors().size())
                .mapToObj(steps -> copy.withBearing(roundBearing(original.bearing() + steps * original.cone())))
                .filter(this::looksDifferent)
                .findFirst()
                .orElse(copy);
    }

    private boolean looksDifferent(SensorSpec copy) {
        return robot.sensors().stream()
                .noneMatch(sensor -> sensor.mountPosition().distanceTo(copy.mountPosition()) < SAME_PLACE
                        && angleBetween(sensor.bearing(), copy.bearing()) < SAME_BEARING);
    }
}
