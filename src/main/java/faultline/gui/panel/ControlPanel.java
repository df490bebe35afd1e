package faultline.gui.panel;

import faultline.gui.edit.Editor;
import faultline.gui.text.Texts;
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

    private static final int WHEEL = 16;
    private static final int WIDTH = 436;

    private final RobotPanel robot;
    private final SensorsPanel sensors;
    private final ChosenSensorPanel chosen;
    private final transient SensorEchoes echoes = new SensorEchoes();

    /**
     * A panel that shows nothing yet.
     *
     * @param editor where all changes go
     * @param path shows or hides the path
     */
    public ControlPanel(Editor editor, Action path) {
        super(new BorderLayout());
        robot = new RobotPanel(editor, path);
        sensors = new SensorsPanel(echoes, editor);
        chosen = new ChosenSensorPanel(echoes, editor);
        sensors.addSelectionListener(chosen::choose);
        chosen.addChoiceListener(sensors::choose);
        JPanel column = new JPanel();
        column.setLayout(new BoxLayout(column, BoxLayout.PAGE_AXIS));
        column.add(new Section(Texts.text("robot.title"), robot));
        column.add(new Section(Texts.text("sensors.title"), sensors));
        column.add(new Section(Texts.text("faults.title"), chosen));
        JPanel top = new JPanel(new BorderLayout());
        top.add(column, BorderLayout.NORTH);
        JScrollPane scroll = new JScrollPane(top, ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED,
                ScrollPaneConstants.HORIZONTAL_SCROLLBAR_AS_NEEDED);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.getVerticalScrollBar().setUnitIncrement(WHEEL);
        scroll.getHorizontalScrollBar().setUnitIncrement(WHEEL);
        add(scroll, BorderLayout.CENTER);
    }

    /** As wide as at the normal size of texts; larger ones can be scrolled to where the window has no room for more. */
    @Override
    public Dimension getMinimumSize() {
        return new Dimension(WIDTH, super.getMinimumSize().height);
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(usualWidth(), super.getPreferredSize().height);
    }

    /**
     * Wide enough for its rows before there are any, and for the scroll bar before it comes.
     *
     * @return pixels
     */
    public int usualWidth() {
        return TextSize.scaled(WIDTH);
    }

    /**
     * Shows how the world is now.
     *
     * @param world the newest snapshot
     */
    public void show(Snapshot world) {
        assert EventQueue.isDispatchThread();
        robot.show(world.robot());
        echoes.told(world.sensors());
        sensors.show(world.sensors());
        chosen.show(world.sensors());
    }

    /**
     * Takes a number that is being typed, as if the field were left.
     *
     * @return whether that changed anything
     */
    public boolean settle() {
        Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        return SwingUtilities.getAncestorOfClass(NumberSpinner.class, owner) instanceof NumberSpinner typed && isAncestorOf(typed) && typed.settle();
    }

    /**
     * Marks a sensor's row, and shows how it is mounted.
     *
     * @param sensor its id, empty for none
     */
    public void select(Optional<String> sensor) {
        sensors.select(sensor);
        chosen.choose(sensor);
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
