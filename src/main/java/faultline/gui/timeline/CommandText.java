package faultline.gui.timeline;

import faultline.gui.panel.ControllerText;
import faultline.gui.text.FaultText;
import faultline.gui.text.Messages;
import faultline.gui.text.NumberText;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.world.Command;

/** Describes commands in the user's language. */
public final class CommandText {

    private CommandText() {}

    /** Returns what a command does, as one sentence. */
    public static String format(Command command) {
        return command.match(new Command.CommandCases<>(
                switchSensor -> Messages.get(switchSensor.on() ? "command.on" : "command.off", switchSensor.sensor()),
                configureSensor -> Messages.get(
                        "command.tune",
                        configureSensor.sensor().id(),
                        NumberText.format("%.2f", configureSensor.sensor().range()),
                        NumberText.format(
                                "%.1f", Math.toDegrees(configureSensor.sensor().cone()))),
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
                        NumberText.format("%.2f", setPlatform.speed())),
                configureController ->
                        Messages.get("command.controller", ControllerText.format(configureController.controller()))));
    }

    private static String motorText(String key, MotorSide motor, MotorFault fault) {
        return Messages.get(key, FaultText.motors(motor), FaultText.format(fault));
    }
}
