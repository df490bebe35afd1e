package faultline.gui.panel;

import faultline.gui.edit.CommandSink;
import faultline.gui.text.Messages;
import faultline.gui.theme.TextSize;
import faultline.world.Snapshot;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.Action;
import javax.swing.BorderFactory;
import javax.swing.BoxLayout;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ScrollPaneConstants;
import javax.swing.SwingUtilities;

/** The control panel of the paper's Fig. 1: the robot, its sensors and its faults, one below the other. */
public final class ControlPanel extends JPanel {

    private static final int WHEEL_STEP = 16;
    private static final int WIDTH = 436;

    private final RobotPanel robot;
    private final SensorsPanel sensors;
    private final SensorDetailsPanel sensorDetails;
    private final transient OptimisticSensors optimisticSensors = new OptimisticSensors();

    /**
     * A panel that shows nothing yet.
     *
     * @param editor where all changes go
     * @param path shows or hides the path
     */
    public ControlPanel(CommandSink editor, Action path) {
        super(new BorderLayout());
        robot = new RobotPanel(editor, path);
        sensors = new SensorsPanel(optimisticSensors, editor);
        sensorDetails = new SensorDetailsPanel(optimisticSensors, editor);
        sensors.addSelectionListener(sensorDetails::selectSensor);
        sensorDetails.addChoiceListener(sensors::selectByUser);
        JPanel column = new JPanel();
        column.setLayout(new BoxLayout(column, BoxLayout.PAGE_AXIS));
        column.add(new TitledSection(Messages.get("robot.title"), robot));
        column.add(new TitledSection(Messages.get("sensors.title"), sensors));
        column.add(new TitledSection(Messages.get("faults.title"), sensorDetails));
        JPanel top = new JPanel(new BorderLayout());
        top.add(column, BorderLayout.NORTH);
        JScrollPane scroll = new JScrollPane(
                top,
                ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED,
                ScrollPaneConstants.HORIZONTAL_SCROLLBAR_AS_NEEDED);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.getVerticalScrollBar().setUnitIncrement(WHEEL_STEP);
        scroll.getHorizontalScrollBar().setUnitIncrement(WHEEL_STEP);
        add(scroll, BorderLayout.CENTER);
    }

    /** As wide as at the normal size of texts; larger ones can be scrolled to where the window has no room for more. */
    @Override
    public Dimension getMinimumSize() {
        return new Dimension(WIDTH, super.getMinimumSize().height);
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(defaultWidth(), super.getPreferredSize().height);
    }

    /**
     * Wide enough for its rows before there are any, and for the scroll bar before it comes.
     *
     * @return pixels
     */
    public int defaultWidth() {
        return TextSize.scaled(WIDTH);
    }

    /**
     * Shows how the world is now.
     *
     * @param world the newest snapshot
     */
    public void setSnapshot(Snapshot world) {
        assert EventQueue.isDispatchThread();
        robot.setRobot(world.robot());
        optimisticSensors.update(world.sensors());
        sensors.setSensors(world.sensors());
        sensorDetails.setSensors(world.sensors());
    }

    /**
     * Takes a number that is being typed, as if the field were left.
     *
     * @return whether that changed anything
     */
    public boolean commitPendingEdit() {
        Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        return SwingUtilities.getAncestorOfClass(NumberSpinner.class, owner) instanceof NumberSpinner typed
                && isAncestorOf(typed)
                && typed.commitPendingEdit();
    }

    /**
     * Marks a sensor's row, and shows how it is mounted.
     *
     * @param sensor its id, empty for none
     */
    public void selectSensor(Optional<String> sensor) {
        sensors.selectSensor(sensor);
        sensorDetails.selectSensor(sensor);
    }

    /**
     * Tells a listener, from now on, when the user chooses a sensor here.
     *
     * @param listener gets the sensor's id
     */
    public void addSelectionListener(Consumer<Optional<String>> listener) {
        sensors.addSelectionListener(listener);
    }

    /**
     * Switches a sensor the other way.
     *
     * @param index its place in the robot's order, from 0; nothing happens where there is none
     */
    public void toggleSensor(int index) {
        sensors.toggle(index);
    }
}
