package faultline.scenario.xml;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import faultline.robot.DriveScale;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/** Makes the robot and its pose at the start of its element. */
final class RobotReader {

    private static final List<String> CHILD_ELEMENTS = List.of("motor", "sensor");

    private final Problems problems;

    RobotReader(Problems complaints) {
        this.problems = complaints;
    }

    /**
     * The robot as built, and where it starts.
     *
     * @param spec as built
     * @param start its pose at time 0
     */
    record PlacedRobot(RobotSpec spec, Pose start) {}

    PlacedRobot read(XmlElement node) {
        ElementRules.checkChildren(node, CHILD_ELEMENTS, problems);
        ElementRules.checkAtMostOne(node, List.of("motor"), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        RobotSpec usual = RobotSpec.DEFAULT;
        Pose start = new Pose(
                fields.number("x", NumberRange.COORDINATE),
                fields.number("y", NumberRange.COORDINATE),
                fields.angle("heading", NumberRange.ANGLE, 0));
        double length = fields.number("length", NumberRange.SIZE, usual.length());
        double width = fields.number("width", NumberRange.SIZE, usual.width());
        double track = fields.number("track", NumberRange.SIZE, usual.track());
        double trackScale = fields.number("trackScale", NumberRange.DRIVE_SCALE, 1);
        double speed = fields.number("speed", NumberRange.POSITIVE_SPEED, usual.speed());
        double turnRate = fields.angle("turnRate", NumberRange.TURN_RATE, usual.turnRate());
        boolean defaults = fields.flag("defaultSensors", true);
        fields.reportUnknownAndMissing();
        Drive drive = node.firstChild("motor")
                .map(element -> readDrive(element, trackScale))
                .orElse(new Drive(MotorSpec.DEFAULT, new DriveScale(1, 1, trackScale)));
        checkDriveLimits(node, drive, track);
        List<SensorSpec> sensors = readSensors(node, defaults ? RobotSpec.standardSensors(length, width) : List.of());
        return new PlacedRobot(
                new RobotSpec(length, width, track, speed, turnRate, drive.motor(), drive.scale(), sensors), start);
    }

    private void checkDriveLimits(XmlElement node, Drive drive, double track) {
        DriveScale scale = drive.scale();
        MotorSpec motor = drive.motor().scaled(Math.max(scale.left(), scale.right()));
        double spin = 2 * motor.maxSpeed() / (track * scale.track());
        if (motor.maxSpeed() > ScenarioLimits.MAX_WHEEL_SPEED) {
            problems.add(
                    node.firstChild("motor").orElse(node),
                    ProblemKind.WHEEL_SPEED.with(
                            DecimalText.formatRounded(motor.maxSpeed()),
                            DecimalText.format(ScenarioLimits.MAX_WHEEL_SPEED)));
        } else if (spin > ScenarioLimits.MAX_SPIN_RATE) {
            problems.add(
                    node,
                    ProblemKind.SPIN_RATE.with(
                            DecimalText.formatRounded(spin), DecimalText.format(ScenarioLimits.MAX_SPIN_RATE)));
        }
    }

    /** A motor as the controller believes it to be, and the true scale of either side and of the track. */
    private record Drive(MotorSpec motor, DriveScale scale) {}

    private Drive readDrive(XmlElement node, double trackScale) {
        ElementRules.checkChildren(node, List.of(), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        MotorSpec usual = MotorSpec.DEFAULT;
        MotorSpec motor = new MotorSpec(
                fields.number("timeConstant", NumberRange.TIME_CONSTANT, usual.timeConstant()),
                fields.number("speedConstant", NumberRange.SPEED_CONSTANT, usual.speedConstant()),
                fields.number("maxVoltage", NumberRange.POSITIVE_VOLTAGE, usual.maxVoltage()));
        DriveScale scale = new DriveScale(
                fields.number("leftScale", NumberRange.DRIVE_SCALE, 1),
                fields.number("rightScale", NumberRange.DRIVE_SCALE, 1),
                trackScale);
        fields.reportUnknownAndMissing();
        return new Drive(motor, scale);
    }

    /** The standard sensors, each in its place as the file sets it, and after them the file's own. */
    private List<SensorSpec> readSensors(XmlElement robot, List<SensorSpec> standard) {
        List<SensorSpec> sensors = new ArrayList<>(standard);
        Map<String, SourceLocation> ids = new HashMap<>();
        robot.childrenNamed("sensor").forEach(node -> {
            SensorSpec sensor = readSensor(node, standard);
            ElementRules.checkUniqueId(node, sensor.id(), ids, problems);
            addOrReplace(sensor, sensors);
        });
        return sensors;
    }

    private static void addOrReplace(SensorSpec sensor, List<SensorSpec> sensors) {
        IntStream.range(0, sensors.size())
                .filter(i -> sensors.get(i).id().equals(sensor.id()))
                .findFirst()
                .ifPresentOrElse(i -> sensors.set(i, sensor), () -> sensors.add(sensor));
    }

    private SensorSpec readSensor(XmlElement node, List<SensorSpec> standard) {
        ElementRules.checkChildren(node, List.of(), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        String id = fields.id("id");
        Optional<SensorSpec> seated =
                standard.stream().filter(sensor -> sensor.id().equals(id)).findFirst();
        SensorSpec usual = seated.orElseGet(() -> readCustomSensor(id, fields));
        SensorSpec sensor = readAttributes(fields, usual);
        fields.reportUnknownAndMissing();
        return sensor;
    }

    private static SensorSpec readCustomSensor(String id, AttributeReader fields) {
        Vector2 seat =
                new Vector2(fields.number("x", NumberRange.COORDINATE), fields.number("y", NumberRange.COORDINATE));
        double bearing = fields.angle("bearing", NumberRange.ANGLE);
        return new SensorSpec(id, seat, bearing, SensorSpec.DEFAULT_RANGE, SensorSpec.DEFAULT_CONE, true, 0);
    }

    /** Returns a sensor with the attributes of a file, and with those of another sensor where the file has none. */
    static SensorSpec readAttributes(AttributeReader fields, SensorSpec usual) {
        Vector2 seat = new Vector2(
                fields.number("x", NumberRange.COORDINATE, usual.mountPosition().x()),
                fields.number("y", NumberRange.COORDINATE, usual.mountPosition().y()));
        return new SensorSpec(
                usual.id(),
                seat,
                fields.angle("bearing", NumberRange.ANGLE, usual.bearing()),
                fields.number("range", NumberRange.SENSOR_RANGE, usual.range()),
                fields.cone(usual.cone()),
                fields.flag("on", usual.on()),
                fields.number("noise", NumberRange.NOISE, usual.noise()));
    }
}
