package faultline.scenario;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
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

    private static final List<String> INSIDE = List.of("motor", "sensor");

    private final Complaints complaints;

    RobotReader(Complaints complaints) {
        this.complaints = complaints;
    }

    /**
     * The robot as built, and where it starts.
     *
     * @param spec as built
     * @param start its pose at time 0
     */
    record Placed(RobotSpec spec, Pose start) {
    }

    Placed read(Node node) {
        Content.check(node, INSIDE, complaints);
        Content.atMostOne(node, List.of("motor"), complaints);
        Fields fields = new Fields(node, complaints);
        RobotSpec usual = RobotSpec.DEFAULT;
        Pose start = new Pose(fields.number("x", Range.COORDINATE), fields.number("y", Range.COORDINATE),
                fields.angle("heading", Range.ANGLE, 0));
        double length = fields.number("length", Range.SIZE, usual.length());
        double width = fields.number("width", Range.SIZE, usual.width());
        double track = fields.number("track", Range.SIZE, usual.track());
        double speed = fields.number("speed", Range.POSITIVE_SPEED, usual.speed());
        double turnRate = fields.angle("turnRate", Range.TURN_RATE, usual.turnRate());
        boolean defaults = fields.flag("defaultSensors", true);
        fields.done();
        MotorSpec motor = node.first("motor").map(this::motor).orElse(MotorSpec.DEFAULT);
        checkDrive(node, motor, track);
        List<SensorSpec> sensors = sensors(node, defaults ? RobotSpec.standardSensors(length, width) : List.of());
        return new Placed(new RobotSpec(length, width, track, speed, turnRate, motor, sensors), start);
    }

    private void checkDrive(Node node, MotorSpec motor, double track) {
        double spin = 2 * motor.maxSpeed() / track;
        if (motor.maxSpeed() > Limits.FASTEST_WHEEL) {
            complaints.add(node.first("motor").orElse(node), "<motor> drives its wheels at up to " + Numbers.toRoughText(motor.maxSpeed())
                    + " m/s (speedConstant times maxVoltage), allowed is " + Numbers.toText(Limits.FASTEST_WHEEL) + " m/s or less");
        } else if (spin > Limits.FASTEST_SPIN) {
            complaints.add(node, "<robot> could spin at " + Numbers.toRoughText(spin)
                    + " rad/s (twice its wheels' top speed by its track), allowed is "
                    + Numbers.toText(Limits.FASTEST_SPIN) + " rad/s or less");
        }
    }

    private MotorSpec motor(Node node) {
        Content.check(node, List.of(), complaints);
        Fields fields = new Fields(node, complaints);
        MotorSpec usual = MotorSpec.DEFAULT;
        MotorSpec motor = new MotorSpec(fields.number("timeConstant", Range.TIME_CONSTANT, usual.timeConstant()),
                fields.number("speedConstant", Range.SPEED_CONSTANT, usual.speedConstant()),
                fields.number("maxVoltage", Range.POSITIVE_VOLTAGE, usual.maxVoltage()));
        fields.done();
        return motor;
    }

    /** The standard sensors, each in its place as the file sets it, and after them the file's own. */
    private List<SensorSpec> sensors(Node robot, List<SensorSpec> standard) {
        List<SensorSpec> sensors = new ArrayList<>(standard);
        Map<String, Place> ids = new HashMap<>();
        robot.all("sensor").forEach(node -> {
            SensorSpec sensor = sensor(node, standard);
            UniqueIds.check(node, sensor.id(), ids, complaints);
            put(sensor, sensors);
        });
        return sensors;
    }

    private static void put(SensorSpec sensor, List<SensorSpec> sensors) {
        IntStream.range(0, sensors.size()).filter(i -> sensors.get(i).id().equals(sensor.id())).findFirst()
                .ifPresentOrElse(i -> sensors.set(i, sensor), () -> sensors.add(sensor));
    }

    private SensorSpec sensor(Node node, List<SensorSpec> standard) {
        Content.check(node, List.of(), complaints);
        Fields fields = new Fields(node, complaints);
        String id = fields.id("id");
        Optional<SensorSpec> seated = standard.stream().filter(sensor -> sensor.id().equals(id)).findFirst();
        SensorSpec usual = seated.orElseGet(() -> ownSeat(id, fields));
        SensorSpec sensor = SensorFields.read(fields, usual);
        fields.done();
        return sensor;
    }

    private static SensorSpec ownSeat(String id, Fields fields) {
        Vec seat = new Vec(fields.number("x", Range.COORDINATE), fields.number("y", Range.COORDINATE));
        double bearing = fields.angle("bearing", Range.ANGLE);
        return new SensorSpec(id, seat, bearing, SensorSpec.DEFAULT_RANGE, SensorSpec.DEFAULT_CONE, true, 0);
    }
}
