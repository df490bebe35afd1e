package faultline.gui.timeline;

import faultline.gui.panel.ControllerText;
import faultline.gui.text.Messages;
import faultline.gui.text.MotorFaultText;
import faultline.gui.text.ReadingText;
import faultline.world.Command;
import java.util.Locale;

/** Describes commands in the user's language. */
public class CommandText implements Command.Visitor<String> {

    private static final CommandText INSTANCE = new CommandText();

    CommandText() {}

    /** Returns what a command does, as one sentence. */
    public static String format(Command command) {
        return command.accept(INSTANCE);
    }

    @Override
    public String visit(Command.SwitchSensor command) {
        return Messages.get(command.on() ? "command.on" : "command.off", command.sensor());
    }

    @Override
    public String visit(Command.ConfigureSensor command) {
        return Messages.get(
                "command.tune",
                command.sensor().id(),
                number("%.2f", command.sensor().range()),
                number("%.1f", Math.toDegrees(command.sensor().cone())));
    }

    @Override
    public String visit(Command.InjectFault command) {
        return Messages.get("command.inject", command.sensor(), ReadingText.format(command.fault()));
    }

    @Override
    public String visit(Command.ClearFault command) {
        return Messages.get("command.clear", command.sensor(), ReadingText.format(command.fault()));
    }

    @Override
    public String visit(Command.ClearFaults command) {
        return Messages.get("command.clearAll", command.sensor());
    }

    @Override
    public String visit(Command.InjectMotorFault command) {
        return Messages.get(
                "command.inject", MotorFaultText.motors(command.motor()), MotorFaultText.format(command.fault()));
    }

    @Override
    public String visit(Command.ClearMotorFault command) {
        return Messages.get(
                "command.clear", MotorFaultText.motors(command.motor()), MotorFaultText.format(command.fault()));
    }

    @Override
    public String visit(Command.ClearMotorFaults command) {
        return Messages.get("command.clearAll", MotorFaultText.motors(command.motor()));
    }

    @Override
    public String visit(Command.MoveObstacle command) {
        return Messages.get(
                "command.move",
                command.obstacle(),
                number("%.3f", command.pose().x()),
                number("%.3f", command.pose().y()),
                number("%.1f", Math.toDegrees(command.pose().heading())));
    }

    @Override
    public String visit(Command.PlaceObstacle command) {
        return Messages.get("command.put", command.obstacle().id());
    }

    @Override
    public String visit(Command.RemoveObstacle command) {
        return Messages.get("command.remove", command.obstacle());
    }

    @Override
    public String visit(Command.SetPlatform command) {
        return Messages.get(
                "command.platform",
                number("%.3f", command.length()),
                number("%.3f", command.width()),
                number("%.2f", command.speed()));
    }

    @Override
    public String visit(Command.ConfigureController command) {
        return Messages.get("command.controller", ControllerText.format(command.controller()));
    }

    private static String number(String format, double value) {
        return String.format(Locale.ROOT, format, value);
    }
}
