package faultline.gui.timeline;

import faultline.gui.panel.ControllerText;
import faultline.gui.text.FaultText;
import faultline.gui.text.Messages;
import faultline.gui.text.NumberText;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.sensor.SensorSpec;
import faultline.world.Command;

/** Describes commands in the user's language. */
public final class CommandText {

    private CommandText() {}

    /** Returns what a command does, as one sentence. */
    public static String format(Command command) {
        return command.match(new Command.CommandCases<>(
                switchSensor -> Messages.get(switchSensor.on() ? "command.on" : "command.off", switchSensor.sensor()),
                configureSensor -> sensorText(configureSensor.sensor()),
                injectFault ->
                        Messages.get("command.inject", injectFault.sensor(), FaultText.format(injectFault.fault())),
                clearFault -> Messages.get("command.clear", clearFault.sensor(), FaultText.format(clearFault.fault())),
                clearFaults -> Messages.get("command.clearAll", clearFaults.sensor()),
                injectMotorFault -> motorText("command.inject", injectMotorFault.motor(), injectMotorFault.fault()),
                clearMotorFault -> motorText("command.clear", clearMotorFault.motor(), clearMotorFault.fault()),
                clearMotorFaults -> Messages.get("command.clearAll", FaultText.motors(clearMotorFaults.motor())),
                moveObstacle -> Messages.get(
                        "command.move",
                        moveObstacle.obstacle(),
                        NumberText.format("%.3f", moveObstacle.pose().x()),
                        NumberText.format("%.3f", moveObstacle.pose().y()),
                        NumberText.format(
                                "%.1f", Math.toDegrees(moveObstacle.pose().heading()))),
                placeObstacle ->
                        Messages.get("command.put", placeObstacle.obstacle().id()),
                removeObstacle -> Messages.get("command.remove", removeObstacle.obstacle()),
                setPlatform -> Messages.get(
                        "command.platform",
                        NumberText.format("%.3f", setPlatform.length()),
                        NumberText.format("%.3f", setPlatform.width()),
                        NumberText.ofPattern("0.00##", setPlatform.speed())),
                configureController ->
                        Messages.get("command.controller", ControllerText.format(configureController.controller()))));
    }

    /** Names all settings, because a command does not say which of them it changes. */
    private static String sensorText(SensorSpec sensor) {
        return Messages.get(
                "command.tune",
                sensor.id(),
                NumberText.ofPattern("0.00##", sensor.range()),
                NumberText.ofPattern("0.0##", Math.toDegrees(sensor.cone())),
                NumberText.ofPattern("0.0##", Math.toDegrees(sensor.bearing())),
                NumberText.ofPattern("0.00##", sensor.mountPosition().x()),
                NumberText.ofPattern("0.00##", sensor.mountPosition().y()),
                NumberText.ofPattern("0.000##", sensor.noise()));
    }

    private static String motorText(String key, MotorSide motor, MotorFault fault) {
        return Messages.get(key, FaultText.motors(motor), FaultText.format(fault));
    }
}
