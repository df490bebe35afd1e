package faultline.gui.timeline;

import faultline.gui.panel.ControllerText;
import faultline.gui.text.Messages;
import faultline.gui.text.MotorFaultText;
import faultline.gui.text.ReadingText;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.world.Command;
import java.util.Locale;

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
                        number("%.2f", configureSensor.sensor().range()),
                        number("%.1f", Math.toDegrees(configureSensor.sensor().cone()))),
                injectFault ->
                        Messages.get("command.inject", injectFault.sensor(), ReadingText.format(injectFault.fault())),
                clearFault ->
                        Messages.get("command.clear", clearFault.sensor(), ReadingText.format(clearFault.fault())),
                clearFaults -> Messages.get("command.clearAll", clearFaults.sensor()),
                injectMotorFault -> motorText("command.inject", injectMotorFault.motor(), injectMotorFault.fault()),
                clearMotorFault -> motorText("command.clear", clearMotorFault.motor(), clearMotorFault.fault()),
                clearMotorFaults -> Messages.get("command.clearAll", MotorFaultText.motors(clearMotorFaults.motor())),
                moveObstacle -> Messages.get(
                        "command.move",
                        moveObstacle.obstacle(),
                        number("%.3f", moveObstacle.pose().x()),
                        number("%.3f", moveObstacle.pose().y()),
                        number("%.1f", Math.toDegrees(moveObstacle.pose().heading()))),
                placeObstacle ->
                        Messages.get("command.put", placeObstacle.obstacle().id()),
                removeObstacle -> Messages.get("command.remove", removeObstacle.obstacle()),
                setPlatform -> Messages.get(
                        "command.platform",
                        number("%.3f", setPlatform.length()),
                        number("%.3f", setPlatform.width()),
                        number("%.2f", setPlatform.speed())),
                configureController ->
                        Messages.get("command.controller", ControllerText.format(configureController.controller()))));
    }

    private static String motorText(String key, MotorSide motor, MotorFault fault) {
        return Messages.get(key, MotorFaultText.motors(motor), MotorFaultText.format(fault));
    }

    private static String number(String format, double value) {
        return String.format(Locale.ROOT, format, value);
    }
}
