package faultline.scenario;

import faultline.geometry.Pose;
import faultline.robot.DriveScale;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.scenario.xml.XmlWriter;
import faultline.sensor.SensorSpec;
import java.util.List;

/** Writes the robot. Sensors that equal the standard ones are omitted. */
final class RobotWriter {

    private RobotWriter() {}

    static void write(RobotSpec robot, Pose start, XmlWriter out) {
        List<SensorSpec> standard = RobotSpec.standardSensors(robot.length(), robot.width());
        boolean defaults = startsWithIdsOf(standard, robot.sensors());
        WorldWriter.writePose(start, out.beginElement("robot"))
                .attribute("length", robot.length())
                .attribute("width", robot.width())
                .attribute("track", robot.track())
                .attribute("speed", robot.speed())
                .angleAttribute("turnRate", robot.turnRate())
                .attribute("defaultSensors", defaults);
        writeScale("trackScale", robot.driveScale().track(), out);
        writeMotor(robot.motor(), robot.driveScale(), out);
        robot.sensors().stream()
                .filter(sensor -> !(defaults && standard.contains(sensor)))
                .forEach(sensor -> writeSensor(sensor, out));
        out.endElement();
    }

    private static boolean startsWithIdsOf(List<SensorSpec> standard, List<SensorSpec> sensors) {
        return sensors.size() >= standard.size()
                && ids(sensors.subList(0, standard.size())).equals(ids(standard));
    }

    private static List<String> ids(List<SensorSpec> sensors) {
        return sensors.stream().map(SensorSpec::id).toList();
    }

    private static void writeMotor(MotorSpec motor, DriveScale scale, XmlWriter out) {
        out.beginElement("motor")
                .attribute("timeConstant", motor.timeConstant())
                .attribute("speedConstant", motor.speedConstant())
                .attribute("maxVoltage", motor.maxVoltage());
        writeScale("leftScale", scale.left(), out);
        writeScale("rightScale", scale.right(), out);
        out.endElement();
    }

    /** Writes a scale that is not 1. */
    private static void writeScale(String name, double scale, XmlWriter out) {
        if (scale != 1) {
            out.attribute(name, scale);
        }
    }

    private static void writeSensor(SensorSpec sensor, XmlWriter out) {
        writeSettings(sensor, out.beginElement("sensor").attribute("id", sensor.id()))
                .endElement();
    }

    /** Writes all settings of a sensor except its id. */
    static XmlWriter writeSettings(SensorSpec sensor, XmlWriter out) {
        return out.attribute("x", sensor.mountPosition().x())
                .attribute("y", sensor.mountPosition().y())
                .angleAttribute("bearing", sensor.bearing())
                .attribute("range", sensor.range())
                .angleAttribute("cone", sensor.cone())
                .attribute("on", sensor.on())
                .attribute("noise", sensor.noise());
    }
}
