package faultline.scenario;

import faultline.geometry.Pose;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import java.util.List;

/** Writes the robot. Sensors that are just the standard ones are left to the default. */
final class RobotWriter {

    private RobotWriter() {
    }

    static void robot(RobotSpec robot, Pose start, XmlOut out) {
        List<SensorSpec> standard = RobotSpec.standardSensors(robot.length(), robot.width());
        boolean defaults = startsWithIdsOf(standard, robot.sensors());
        WorldWriter.pose(start, out.begin("robot")).set("length", robot.length()).set("width", robot.width()).set("track", robot.track())
                .set("speed", robot.speed()).setAngle("turnRate", robot.turnRate()).set("defaultSensors", defaults);
        motor(robot.motor(), out);
        robot.sensors().stream().filter(sensor -> !(defaults && standard.contains(sensor))).forEach(sensor -> sensor(sensor, out));
        out.end();
    }

    private static boolean startsWithIdsOf(List<SensorSpec> standard, List<SensorSpec> sensors) {
        return sensors.size() >= standard.size() && ids(sensors.subList(0, standard.size())).equals(ids(standard));
    }

    private static List<String> ids(List<SensorSpec> sensors) {
        return sensors.stream().map(SensorSpec::id).toList();
    }

    private static void motor(MotorSpec motor, XmlOut out) {
        out.begin("motor").set("timeConstant", motor.timeConstant()).set("speedConstant", motor.speedConstant())
                .set("maxVoltage", motor.maxVoltage()).end();
    }

    private static void sensor(SensorSpec sensor, XmlOut out) {
        settings(sensor, out.begin("sensor").set("id", sensor.id())).end();
    }

    /** All of a sensor but its id. */
    static XmlOut settings(SensorSpec sensor, XmlOut out) {
        return out.set("x", sensor.seat().x()).set("y", sensor.seat().y()).setAngle("bearing", sensor.bearing())
                .set("range", sensor.range()).setAngle("cone", sensor.cone()).set("on", sensor.on()).set("noise", sensor.noise());
    }
}
