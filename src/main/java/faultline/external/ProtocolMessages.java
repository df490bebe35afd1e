package faultline.external;

import faultline.control.Observation;
import faultline.engine.Simulation;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import faultline.io.JsonWriter;
import faultline.io.MessageText;
import faultline.robot.DriveScale;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.scenario.xml.Allowed;
import faultline.scenario.xml.NumberRange;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** The messages of the protocol as JSON objects. Lengths are metres, angles radians, times seconds. */
final class ProtocolMessages {

    /** The version of the protocol. */
    static final int PROTOCOL = 1;

    private static final NumberRange TURN_RATE = inRadians(NumberRange.TURN_RATE);
    private static final NumberRange ANGLE = inRadians(NumberRange.ANGLE);

    private ProtocolMessages() {}

    /** Returns the first message of a run. */
    static String hello(RunDescription run) {
        JsonWriter json = new JsonWriter()
                .member("type", "hello")
                .member("protocol", PROTOCOL)
                .member("program", run.program())
                .member("scenario", run.scenario())
                .member("seed", run.conditions().seed())
                .member("dt_s", run.conditions().dt())
                .member("period_ticks", run.conditions().periodTicks())
                .member("duration_s", run.conditions().duration());
        writeRobot(json.name("robot"), run.conditions().robot());
        return json.finish();
    }

    private static void writeRobot(JsonWriter json, RobotSpec robot) {
        json.beginObject()
                .member("length_m", robot.length())
                .member("width_m", robot.width())
                .member("track_m", robot.track())
                .member("speed_m_s", robot.speed())
                .member("turn_rate_rad_s", robot.turnRate())
                .member("max_voltage_v", robot.motor().maxVoltage())
                .member("speed_constant_m_s_v", robot.motor().speedConstant())
                .member("time_constant_s", robot.motor().timeConstant())
                .name("sensors")
                .beginArray();
        for (SensorSpec sensor : robot.sensors()) {
            json.beginObject()
                    .member("id", sensor.id())
                    .member("x_m", sensor.mountPosition().x())
                    .member("y_m", sensor.mountPosition().y())
                    .member("bearing_rad", sensor.bearing())
                    .member("range_m", sensor.range())
                    .member("cone_rad", sensor.cone())
                    .member("on", sensor.on())
                    .member("noise_m", sensor.noise())
                    .endObject();
        }
        json.endArray().endObject();
    }

    /** Returns an observation. The robot is written only if it was changed. */
    static JsonWriter observe(Observation observation, boolean robotChanged) {
        JsonWriter json = new JsonWriter().member("type", "observe");
        writeReadings(json, observation, robotChanged);
        return json;
    }

    /** Writes the tick, the time and the readings of an observation, and its robot if that was changed. */
    static void writeReadings(JsonWriter json, Observation observation, boolean robotChanged) {
        json.member("tick", observation.tick()).member("t_s", observation.tick() * observation.dt());
        json.name("readings_m").beginArray();
        for (double reading : observation.readings()) {
            writeReading(json, reading);
        }
        json.endArray().name("answers").beginArray();
        for (double reading : observation.readings()) {
            json.value(!Reading.isOff(reading));
        }
        json.endArray();
        if (robotChanged) {
            writeRobot(json.name("robot"), observation.robot());
        }
    }

    private static void writeReading(JsonWriter json, double reading) {
        if (Double.isFinite(reading)) {
            json.value(reading);
        } else {
            json.nullValue();
        }
    }

    /**
     * Writes the ground truth, which no controller should use: the true pose, the true readings, and whether the robot
     * has collided.
     */
    static void writeTruth(JsonWriter json, Simulation simulation) {
        Pose pose = simulation.pose();
        json.name("truth").beginObject().name("pose").beginObject();
        json.member("x_m", pose.x())
                .member("y_m", pose.y())
                .member("heading_rad", pose.heading())
                .endObject();
        json.name("readings_m").beginArray();
        for (int i = 0; i < simulation.robot().sensors().size(); i++) {
            writeReading(json, simulation.trueReading(i));
        }
        json.endArray().member("collided", simulation.collision().isPresent()).endObject();
    }

    /** Reads the robot of a {@code hello} or {@code observe} message. */
    static RobotSpec readRobot(MessageReader robot) throws ProtocolException {
        try {
            return toRobot(robot);
        } catch (IllegalArgumentException e) {
            throw new ProtocolException("describes a robot that cannot be", ": " + MessageText.oneLine(e.getMessage()));
        }
    }

    private static NumberRange inRadians(NumberRange degrees) {
        return NumberRange.closed(Degrees.toRadians(degrees.min()), Degrees.toRadians(degrees.max()), Allowed.UNITLESS);
    }

    private static RobotSpec toRobot(MessageReader robot) throws ProtocolException {
        List<SensorSpec> sensors = new ArrayList<>();
        for (MessageReader sensor : robot.objects("sensors")) {
            sensors.add(new SensorSpec(
                    sensor.string("id"),
                    new Vector2(
                            number(sensor, "x_m", NumberRange.COORDINATE),
                            number(sensor, "y_m", NumberRange.COORDINATE)),
                    number(sensor, "bearing_rad", ANGLE),
                    number(sensor, "range_m", NumberRange.SENSOR_RANGE),
                    sensor.number("cone_rad"),
                    sensor.flag("on", true),
                    sensor.has("noise_m") ? number(sensor, "noise_m", NumberRange.NOISE) : 0));
        }
        MotorSpec motor = new MotorSpec(
                number(robot, "time_constant_s", NumberRange.TIME_CONSTANT),
                number(robot, "speed_constant_m_s_v", NumberRange.SPEED_CONSTANT),
                number(robot, "max_voltage_v", NumberRange.POSITIVE_VOLTAGE));
        return new RobotSpec(
                number(robot, "length_m", NumberRange.SIZE),
                number(robot, "width_m", NumberRange.SIZE),
                number(robot, "track_m", NumberRange.SIZE),
                number(robot, "speed_m_s", NumberRange.POSITIVE_SPEED),
                number(robot, "turn_rate_rad_s", TURN_RATE),
                motor,
                DriveScale.NONE,
                sensors);
    }

    /** Returns a number of a robot that is within the limits of scenarios, because controllers expect no other. */
    private static double number(MessageReader source, String name, NumberRange range) throws ProtocolException {
        double value = source.number(name);
        if (value < range.min().doubleValue() || value > range.max().doubleValue()) {
            throw new ProtocolException(
                    "describes a robot that cannot be",
                    ": its " + name + " is " + DecimalText.format(value) + "; expected " + range.rule());
        }
        return value;
    }

    /** Returns the last message of a run, whose summary also says whether the controller was given the ground truth. */
    static JsonWriter end(String reason, String trajectoryHash, Map<String, String> summary, boolean givesTruth) {
        JsonWriter json = new JsonWriter()
                .member("type", "end")
                .member("reason", reason)
                .member("trajectory_hash", trajectoryHash)
                .name("summary")
                .beginObject();
        if (givesTruth) {
            json.member("truth", "given to the controller");
        }
        summary.forEach(json::member);
        return json.endObject();
    }
}
