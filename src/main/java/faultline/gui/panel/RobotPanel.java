package faultline.gui.panel;

import faultline.gui.edit.CommandSender;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.NumberSpinner;
import faultline.gui.form.WrappingGridLayout;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import java.awt.EventQueue;
import java.awt.GridBagConstraints;
import java.math.BigDecimal;
import java.math.RoundingMode;
import javax.swing.Action;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** The robot's linear velocity and platform, and whether its path is drawn. */
public final class RobotPanel extends JPanel {

    private static final double MIN_VALUE = 0.01;
    private static final double MAX_SIZE = 10;
    /** The decimals of the format of the velocity, so that its limit is not rounded up where it is shown. */
    private static final int SPEED_DECIMALS = 4;

    private static final int COLUMN_GAP = 12;

    private final transient CommandSender sender;
    private final NumberSpinner speed = new NumberSpinner(
            "0.00##",
            MIN_VALUE,
            speedLimit(RobotSpec.DEFAULT.motor().maxSpeed()),
            0.05,
            value -> sendPlatform(robot().length(), robot().width(), value));
    private final NumberSpinner length = new NumberSpinner(
            "0.00##", MIN_VALUE, MAX_SIZE, 0.01, value -> sendPlatform(value, robot().width(), robot().speed()));
    private final NumberSpinner width = new NumberSpinner(
            "0.00##", MIN_VALUE, MAX_SIZE, 0.01, value -> sendPlatform(robot().length(), value, robot().speed()));

    private double maxSpeed = RobotSpec.DEFAULT.motor().maxSpeed();

    /** Creates the robot's controls, given the action that shows or hides the path. */
    public RobotPanel(CommandSender sender, Action path) {
        super(new WrappingGridLayout());
        this.sender = sender;
        addField(0, 0, "robot.speed", speed, "m/s");
        addField(0, 1, "robot.length", length, "m");
        addField(2, 1, "robot.width", width, "m");
        JCheckBox drawPath = new JCheckBox(path);
        drawPath.setIcon(null);
        RefreshSteps.add(drawPath, box -> {
            box.setText(Messages.get("robot.path"));
            box.setMnemonic(0);
        });
        GridBagConstraints constraints = FormConstraints.fillRow(2, 0);
        constraints.insets.left += COLUMN_GAP - 2;
        add(drawPath, constraints);
    }

    private void addField(int column, int row, String key, NumberSpinner spinner, String unit) {
        JLabel label = RefreshSteps.add(new JLabel(), self -> self.setText(Messages.get(key + ".label", unit)));
        spinner.withName(key).withColumns(6);
        label.setLabelFor(spinner);
        GridBagConstraints labelCell = FormConstraints.cell(column, row);
        labelCell.insets.left += column == 0 ? 0 : COLUMN_GAP;
        labelCell.weightx = column == 0 ? 0 : 1;
        add(label, labelCell);
        add(spinner, FormConstraints.cell(column + 1, row));
    }

    private RobotSpec robot() {
        return sender.pendingEdits().robot();
    }

    private void sendPlatform(double newLength, double newWidth, double newSpeed) {
        sender.send(new Command.SetPlatform(newLength, newWidth, newSpeed));
    }

    /** Returns a velocity of the motors without the decimals that the field does not show, unless nothing is left. */
    private static double speedLimit(double motorSpeed) {
        double rounded = BigDecimal.valueOf(motorSpeed)
                .setScale(SPEED_DECIMALS, RoundingMode.FLOOR)
                .doubleValue();
        return rounded > 0 ? rounded : motorSpeed;
    }

    /** Shows the current settings of the robot. */
    public void setRobot(RobotSpec robot) {
        assert EventQueue.isDispatchThread();
        if (robot.motor().maxSpeed() != maxSpeed) {
            maxSpeed = robot.motor().maxSpeed();
            double limit = speedLimit(maxSpeed);
            speed.setLimits(Math.min(MIN_VALUE, limit), limit, robot.speed());
        }
        speed.setWorldValue(robot.speed());
        length.setWorldValue(robot.length());
        width.setWorldValue(robot.width());
    }
}
