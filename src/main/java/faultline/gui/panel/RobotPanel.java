package faultline.gui.panel;

import faultline.gui.edit.Editor;
import faultline.gui.text.Texts;
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

    private static final double LEAST = 0.01;
    private static final double MOST_SIZE = 10;
    private static final double MOST_SPEED = 100;
    private static final int UNIT_WIDTH = 30;

    private final transient Echo<Command.SetPlatform> platform = new Echo<>(platform(RobotSpec.DEFAULT));
    private final transient Editor editor;
    private final NumberSpinner speed = new NumberSpinner("0.00##", LEAST, MOST_SPEED, 0.05, value -> {
        Command.SetPlatform now = platform.value();
        set(new Command.SetPlatform(now.length(), now.width(), value));
    });
    private final NumberSpinner length = new NumberSpinner("0.00##", LEAST, MOST_SIZE, 0.01, value -> {
        Command.SetPlatform now = platform.value();
        set(new Command.SetPlatform(value, now.width(), now.speed()));
    });
    private final NumberSpinner width = new NumberSpinner("0.00##", LEAST, MOST_SIZE, 0.01, value -> {
        Command.SetPlatform now = platform.value();
        set(new Command.SetPlatform(now.length(), value, now.speed()));
    });

    /**
     * The robot's controls.
     *
     * @param editor where changes go
     * @param path shows or hides the path
     */
    public RobotPanel(Editor editor, Action path) {
        super(new GridBagLayout());
        this.editor = editor;
        addRow(0, "robot.speed", speed, "m/s");
        addRow(1, "robot.length", length, "m");
        addRow(2, "robot.width", width, "m");
        JCheckBox drawPath = new JCheckBox(path);
        drawPath.setIcon(null);
        drawPath.setText(Texts.text("robot.path"));
        drawPath.setMnemonic(0);
        GridBagConstraints place = Grid.rest(0, 3);
        place.insets.top += 2;
        place.insets.left -= 2;
        add(drawPath, place);
    }

    private void addRow(int row, String key, NumberSpinner spinner, String unit) {
        JLabel label = new JLabel(Texts.text(key));
        spinner.named(Texts.text(key)).columns(6);
        label.setLabelFor(spinner);
        add(label, Grid.wide(0, row));
        add(spinner, Grid.cell(1, row));
        add(unit(unit), Grid.cell(2, row));
    }

    /** All as wide as the widest, so that the fields stand in line. */
    private static JLabel unit(String text) {
        JLabel label = new MutedLabel(text);
        label.setPreferredSize(new Dimension(TextSize.scaled(UNIT_WIDTH), label.getPreferredSize().height));
        return label;
    }

    private static Command.SetPlatform platform(RobotSpec robot) {
        return new Command.SetPlatform(robot.length(), robot.width(), robot.speed());
    }

    private void set(Command.SetPlatform wanted) {
        editor.send(platform.ask(wanted));
    }

    /**
     * Shows how the robot is now.
     *
     * @param robot as built and set
     */
    public void show(RobotSpec robot) {
        assert EventQueue.isDispatchThread();
        Command.SetPlatform shown = platform.told(platform(robot));
        speed.follow(shown.speed());
        length.follow(shown.length());
        width.follow(shown.width());
    }
}
