package faultline.gui.panel;

import faultline.gui.edit.UndoController;
import faultline.gui.text.Messages;
import faultline.gui.theme.TextSize;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import javax.swing.Action;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** The robot's linear velocity and platform, and whether its path is drawn. */
public final class RobotPanel extends JPanel {

    private static final double MIN_VALUE = 0.01;
    private static final double MAX_SIZE = 10;
    private static final double MAX_SPEED = 100;
    private static final int UNIT_WIDTH = 30;

    private final transient UndoController editor;
    private final NumberSpinner speed = new NumberSpinner(
            "0.00##", MIN_VALUE, MAX_SPEED, 0.05, value -> sendPlatform(robot().length(), robot().width(), value));
    private final NumberSpinner length = new NumberSpinner(
            "0.00##", MIN_VALUE, MAX_SIZE, 0.01, value -> sendPlatform(value, robot().width(), robot().speed()));
    private final NumberSpinner width = new NumberSpinner(
            "0.00##", MIN_VALUE, MAX_SIZE, 0.01, value -> sendPlatform(robot().length(), value, robot().speed()));

    /**
     * Creates the robot's controls.
     *
     * @param editor receives the changes
     * @param path shows or hides the path
     */
    public RobotPanel(UndoController editor, Action path) {
        super(new GridBagLayout());
        this.editor = editor;
        addRow(0, "robot.speed", speed, "m/s");
        addRow(1, "robot.length", length, "m");
        addRow(2, "robot.width", width, "m");
        JCheckBox drawPath = new JCheckBox(path);
        drawPath.setIcon(null);
        drawPath.setText(Messages.get("robot.path"));
        drawPath.setMnemonic(0);
        GridBagConstraints constraints = FormConstraints.fillRow(0, 3);
        constraints.insets.top += 2;
        constraints.insets.left -= 2;
        add(drawPath, constraints);
    }

    private void addRow(int row, String key, NumberSpinner spinner, String unit) {
        JLabel label = new JLabel(Messages.get(key));
        spinner.withName(Messages.get(key)).withColumns(6);
        label.setLabelFor(spinner);
        add(label, FormConstraints.fillCell(0, row));
        add(spinner, FormConstraints.cell(1, row));
        add(createUnitLabel(unit), FormConstraints.cell(2, row));
    }

    /** Returns a label as wide as the widest unit, so that the fields are aligned. */
    private static JLabel createUnitLabel(String text) {
        JLabel label = new MutedLabel(text);
        label.setPreferredSize(new Dimension(TextSize.scaled(UNIT_WIDTH), label.getPreferredSize().height));
        return label;
    }

    private RobotSpec robot() {
        return editor.pendingEdits().robot();
    }

    private void sendPlatform(double newLength, double newWidth, double newSpeed) {
        editor.send(new Command.SetPlatform(newLength, newWidth, newSpeed));
    }

    /** Shows the current settings of the robot. */
    public void setRobot(RobotSpec robot) {
        assert EventQueue.isDispatchThread();
        speed.setWorldValue(robot.speed());
        length.setWorldValue(robot.length());
        width.setWorldValue(robot.width());
    }
}
