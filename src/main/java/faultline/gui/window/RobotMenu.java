package faultline.gui.window;

import faultline.gui.action.SensorActions;
import faultline.gui.edit.CommandSender;
import faultline.gui.theme.UiText;
import faultline.robot.MotorFaults;
import faultline.robot.MotorSide;
import faultline.world.Command;
import faultline.world.SensorSnapshot;
import java.util.function.Consumer;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;

/**
 * The items of context menus that concern the robot: its sensors are switched, get faults, and are added and removed;
 * its motors get faults.
 */
final class RobotMenu {

    private final CommandSender sender;
    private final SensorActions actions;
    private final Consumer<String> newFault;
    private final Consumer<MotorSide> newMotorFault;

    /**
     * Creates the items; {@code newFault} receives the id of a sensor for which it asks for a fault, and
     * {@code newMotorFault} the side of motors.
     */
    RobotMenu(
            CommandSender sender, SensorActions actions, Consumer<String> newFault, Consumer<MotorSide> newMotorFault) {
        this.sender = sender;
        this.actions = actions;
        this.newFault = newFault;
        this.newMotorFault = newMotorFault;
    }

    /** Adds the items about the motors, which have some faults, to a menu. */
    void addMotors(JPopupMenu popup, MotorFaults faults) {
        for (MotorSide side : MotorSide.values()) {
            add(popup, "fault." + side.fileName(), "", () -> newMotorFault.accept(side));
            add(popup, "repair." + side.fileName(), "", () -> sender.send(new Command.ClearMotorFaults(side)))
                    .setEnabled(!faults.of(side).isEmpty());
        }
        popup.addSeparator();
    }

    /** Adds the items about one sensor to a menu. */
    void addSensor(JPopupMenu popup, SensorSnapshot sensor) {
        String id = sensor.spec().id();
        boolean on = sensor.spec().on();
        add(popup, on ? "off" : "on", id, () -> sender.send(new Command.SwitchSensor(id, !on)));
        add(popup, "fault", id, () -> newFault.accept(id));
        add(popup, "repair", id, () -> sender.send(new Command.ClearFaults(id)))
                .setEnabled(!sensor.faults().isEmpty());
        popup.addSeparator();
        add(popup, "duplicate", id, () -> actions.duplicate(id));
        add(popup, "delete", id, () -> actions.remove(id));
        popup.addSeparator();
    }

    /** Adds the item that adds a sensor in a direction, radians from straight ahead, to a menu. */
    void addNewSensor(JPopupMenu popup, double direction) {
        add(popup, "add", "", () -> actions.add(direction));
        popup.addSeparator();
    }

    private static JMenuItem add(JPopupMenu popup, String key, String id, Runnable action) {
        JMenuItem item = popup.add(UiText.menuText(new JMenuItem(), "robotMenu." + key, id));
        item.addActionListener(event -> action.run());
        return item;
    }
}
