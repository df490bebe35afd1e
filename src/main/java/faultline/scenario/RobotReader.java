package faultline.scenario;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import faultline.io.MessageText;
import faultline.robot.DriveScale;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.scenario.xml.Allowed;
import faultline.scenario.xml.AttributeReader;
import faultline.scenario.xml.ElementRules;
import faultline.scenario.xml.NumberRange;
import faultline.scenario.xml.ProblemKind;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.ScenarioLimits;
import faultline.scenario.xml.SourceLocation;
import faultline.scenario.xml.XmlElement;
import faultline.sensor.SensorSpec;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/** Reads the robot and its initial pose. */
final class RobotReader {

    private static final List<String> CHILD_ELEMENTS = List.of("motor", "sensor");

    /** The attributes that a sensor needs unless it is a standard one. */
    private static final List<String> PLACE = List.of("x", "y", "bearing");

    private final Problems problems;

    RobotReader(Problems problems) {
        this.problems = problems;
    }

    /** A robot and its initial pose. */
    record PlacedRobot(RobotSpec spec, Pose start) {}

    PlacedRobot read(XmlElement node) {
        ElementRules.checkChildren(node, CHILD_ELEMENTS, problems);
        ElementRules.checkAtMostOne(node, List.of("motor"), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        RobotSpec defaults = RobotSpec.DEFAULT;
        Pose start = new Pose(
                fields.number("x", NumberRange.COORDINATE),
                fields.number("y", NumberRange.COORDINATE),
                fields.angle("heading", NumberRange.ANGLE, 0));
        double length = fields.number("length", NumberRange.SIZE, defaults.length());
        double width = fields.number("width", NumberRange.SIZE, defaults.width());
        double track = fields.number("track", NumberRange.SIZE, defaults.track());
        double trackScale = fields.number("trackScale", NumberRange.DRIVE_SCALE, 1);
        double speed = fields.number("speed", NumberRange.POSITIVE_SPEED, defaults.speed());
        double turnRate = fields.angle("turnRate", NumberRange.TURN_RATE, defaults.turnRate());
        boolean standard = fields.flag("defaultSensors", true);
        fields.reportUnknownAndMissing();
        ScaledMotor drive = node.firstChild("motor")
                .map(element -> readDrive(element, trackScale))
                .orElse(new ScaledMotor(MotorSpec.DEFAULT, new DriveScale(1, 1, trackScale)));
        checkDriveLimits(node, drive, track);
        List<SensorSpec> sensors = readSensors(node, standard ? RobotSpec.standardSensors(length, width) : List.of());
        return new PlacedRobot(
                new RobotSpec(length, width, track, speed, turnRate, drive.motor(), drive.scale(), sensors), start);
    }

    private void checkDriveLimits(XmlElement node, ScaledMotor drive, double track) {
        DriveScale scale = drive.scale();
        MotorSpec motor = drive.motor().scaled(Math.max(scale.left(), scale.right()));
        double spin = 2 * motor.maxSpeed() / (track * scale.track());
        if (motor.maxSpeed() > ScenarioLimits.MAX_WHEEL_SPEED) {
            problems.add(
                    node.firstChild("motor").orElse(node),
                    ProblemKind.WHEEL_SPEED.with(
                            DecimalText.formatRefused(motor.maxSpeed(), ScenarioLimits.MAX_WHEEL_SPEED),
                            DecimalText.format(ScenarioLimits.MAX_WHEEL_SPEED)));
        } else if (spin > ScenarioLimits.MAX_SPIN_RATE) {
            problems.add(
                    node,
                    ProblemKind.SPIN_RATE.with(
                            DecimalText.formatRefused(spin, ScenarioLimits.MAX_SPIN_RATE),
                            DecimalText.format(ScenarioLimits.MAX_SPIN_RATE)));
        }
    }

    /** A motor as the controller believes it to be, and the true scale of either side and of the track. */
    private record ScaledMotor(MotorSpec motor, DriveScale scale) {}

    private ScaledMotor readDrive(XmlElement node, double trackScale) {
        ElementRules.checkChildren(node, List.of(), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        MotorSpec defaults = MotorSpec.DEFAULT;
        MotorSpec motor = new MotorSpec(
                fields.number("timeConstant", NumberRange.TIME_CONSTANT, defaults.timeConstant()),
                fields.number("speedConstant", NumberRange.SPEED_CONSTANT, defaults.speedConstant()),
                fields.number("maxVoltage", NumberRange.POSITIVE_VOLTAGE, defaults.maxVoltage()));
        DriveScale scale = new DriveScale(
                fields.number("leftScale", NumberRange.DRIVE_SCALE, 1),
                fields.number("rightScale", NumberRange.DRIVE_SCALE, 1),
                trackScale);
        fields.reportUnknownAndMissing();
        return new ScaledMotor(motor, scale);
    }

    /** Returns the standard sensors with the settings of the file, followed by the file's other sensors. */
    private List<SensorSpec> readSensors(XmlElement robot, List<SensorSpec> standard) {
        Map<String, SensorSpec> sensors = new LinkedHashMap<>();
        standard.forEach(sensor -> sensors.put(sensor.id(), sensor));
        Map<String, SourceLocation> ids = new HashMap<>();
        List<XmlElement> elements = robot.childrenNamed("sensor").toList();
        List<String> known = Stream.concat(
                        standard.stream().map(SensorSpec::id),
                        elements.stream()
                                .filter(RobotReader::hasPlace)
                                .flatMap(node ->
                                        Stream.ofNullable(node.attributes().get("id"))))
                .distinct()
                .toList();
        elements.stream().limit(ScenarioLimits.MAX_SENSORS).forEach(node -> {
            SensorSpec sensor = readSensor(node, standard, known);
            ElementRules.checkUniqueId(node, sensor.id(), ids, problems);
            sensors.put(sensor.id(), sensor);
        });
        if (Math.max(elements.size(), sensors.size()) > ScenarioLimits.MAX_SENSORS) {
            problems.add(robot, ProblemKind.TOO_MANY_SENSORS.with(ScenarioLimits.MAX_SENSORS));
        }
        return List.copyOf(sensors.values());
    }

    private static boolean hasPlace(XmlElement sensor) {
        return PLACE.stream().anyMatch(sensor.attributes()::containsKey);
    }

    /** Reads a sensor, given the standard ones and the ids of those that have a place on the robot. */
    private SensorSpec readSensor(XmlElement node, List<SensorSpec> standard, List<String> known) {
        ElementRules.checkChildren(node, List.of(), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        String id = fields.id("id");
        Optional<SensorSpec> standardSensor =
                standard.stream().filter(sensor -> sensor.id().equals(id)).findFirst();
        SensorSpec defaults = standardSensor.orElseGet(() -> {
            if (hasPlace(node) || known.isEmpty() || !fields.isValid("id", id)) {
                return readCustomSensor(id, fields);
            }
            // It is likely to be one of the others, misspelt.
            problems.add(node, () -> ProblemKind.NEW_SENSOR.with(MessageText.excerpt(id), Allowed.names(known, id)));
            return RobotSpec.DEFAULT.sensors().get(0).withId(id);
        });
        SensorSpec sensor = readAttributes(fields, defaults);
        fields.reportUnknownAndMissing();
        return sensor;
    }

    private static SensorSpec readCustomSensor(String id, AttributeReader fields) {
        Vector2 mountPosition =
                new Vector2(fields.number("x", NumberRange.COORDINATE), fields.number("y", NumberRange.COORDINATE));
        double bearing = fields.angle("bearing", NumberRange.ANGLE);
        return new SensorSpec(id, mountPosition, bearing, SensorSpec.DEFAULT_RANGE, SensorSpec.DEFAULT_CONE, true, 0);
    }

    /** Returns a sensor with the attributes of a file, and with those of another sensor where the file has none. */
    static SensorSpec readAttributes(AttributeReader fields, SensorSpec defaults) {
        Vector2 mountPosition = new Vector2(
                fields.number(
                        "x", NumberRange.COORDINATE, defaults.mountPosition().x()),
                fields.number(
                        "y", NumberRange.COORDINATE, defaults.mountPosition().y()));
        return new SensorSpec(
                defaults.id(),
                mountPosition,
                fields.angle("bearing", NumberRange.ANGLE, defaults.bearing()),
                fields.number("range", NumberRange.SENSOR_RANGE, defaults.range()),
                fields.angle("cone", NumberRange.CONE, defaults.cone()),
                fields.flag("on", defaults.on()),
                fields.number("noise", NumberRange.NOISE, defaults.noise()));
    }
}
