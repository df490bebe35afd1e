package faultline.gui.panel;

import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.session.SessionFrame;
import faultline.engine.session.SessionStatus;
import faultline.geometry.Pose;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.form.NarrowingColumn;
import faultline.gui.form.PendingField;
import faultline.gui.form.TitledSection;
import faultline.gui.theme.KeyBindings;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.UiText;
import faultline.robot.RobotSpec;
import faultline.scenario.Scenario;
import faultline.world.Snapshot;
import faultline.world.World;
import faultline.world.WorldSpec;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.beans.PropertyChangeEvent;
import java.beans.PropertyChangeListener;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.Action;
import javax.swing.BorderFactory;
import javax.swing.BoxLayout;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollBar;
import javax.swing.JScrollPane;
import javax.swing.JSpinner;
import javax.swing.JTabbedPane;
import javax.swing.ScrollPaneConstants;
import javax.swing.SwingUtilities;

/**
 * The control panel. Its first tab is that of the paper's Fig. 1, the robot with its sensors and their faults. The
 * others have the settings of the controller, the result of the run so far, and the obstacles.
 */
public final class ControlPanel extends JPanel {

    private static final int SCROLL_MARGIN = 4;
    /** The property of the focus manager that changes with the focus. */
    private static final String FOCUS = "permanentFocusOwner";
    /** The width that fits the sensor rows and the scroll bar, pixels at the normal text size. */
    public static final int WIDTH = 458;

    private static final int MIN_WIDTH = 240;

    private final RobotPanel robot;
    private final SensorsPanel sensors;
    private final SensorDetailsPanel sensorDetails;
    private final ControllerPanel controller;
    private final RunPanel run = new RunPanel();
    private final JTabbedPane tabs = new JTabbedPane();
    private final JPanel robotTab;
    private final transient CommandSender sender;
    private final transient PropertyChangeListener showFocused = this::showFocused;
    /** The controls that the first snapshot enables. */
    private transient List<Component> disabledControls = List.of();

    /** Actions of menus that are also here: those of the path, and of the choice of a controller. */
    public record PanelActions(Action path, Action chooseController, Action scenarioController) {}

    /**
     * What adds a sensor, what removes the one with an id, and what gives the one with an id another and returns why it
     * is refused, empty if it is not.
     */
    public record SensorEdits(
            Runnable add, Consumer<String> remove, BiFunction<String, String, Optional<String>> rename) {}

    /**
     * Creates a panel that shows the default robot, disabled, so that the fields do not move when a robot like it
     * comes. The scenario editor receives changes that need a new simulation.
     */
    public ControlPanel(
            CommandSender sender, ScenarioEditor scenarioEditor, SensorEdits sensorEdits, PanelActions actions) {
        super(new BorderLayout());
        this.sender = sender;
        robot = new RobotPanel(sender, actions.path());
        sensors = new SensorsPanel(sender);
        sensorDetails = new SensorDetailsPanel(sender, sensorEdits);
        controller = new ControllerPanel(sender, scenarioEditor, actions);
        sensors.addSelectionListener(sensorDetails::selectSensor);
        sensorDetails.addChoiceListener(sensors::selectByUser);
        UiText.name(tabs, "panel");
        KeyBindings.bind(tabs, "PAGE_UP", () -> scrollByPage(-1));
        KeyBindings.bind(tabs, "PAGE_DOWN", () -> scrollByPage(1));
        robotTab = createColumn(
                new TitledSection(robot),
                new TitledSection("sensors.title", sensors),
                new TitledSection("faults.title", sensorDetails));
        addTab("panel.robot", robotTab);
        addTab("panel.controller", controller);
        addTab("panel.run", run);
        add(tabs, BorderLayout.CENTER);
        setSnapshot(emptyWorld());
        disabledControls = controlsIn(tabs).filter(Component::isEnabled).toList();
        disabledControls.forEach(control -> control.setEnabled(false));
    }

    @Override
    public void addNotify() {
        super.addNotify();
        focusManager().addPropertyChangeListener(FOCUS, showFocused);
    }

    @Override
    public void removeNotify() {
        focusManager().removePropertyChangeListener(FOCUS, showFocused);
        super.removeNotify();
    }

    private static KeyboardFocusManager focusManager() {
        return KeyboardFocusManager.getCurrentKeyboardFocusManager();
    }

    /** Scrolls to the field that has the focus, which Tab may have moved out of sight. */
    private void showFocused(PropertyChangeEvent event) {
        if (event.getNewValue() instanceof JComponent focused && SwingUtilities.isDescendingFrom(focused, this)) {
            scrollTo(focused);
        }
    }

    /** Scrolls to a field with its frame, and to a number with the arrows beside it. */
    static void scrollTo(JComponent focused) {
        Container spinner = SwingUtilities.getAncestorOfClass(JSpinner.class, focused);
        Component field = spinner == null ? focused : spinner;
        // A text field would scroll only its own text.
        if (field.getParent() instanceof JComponent parent) {
            Rectangle shown = field.getBounds();
            shown.grow(SCROLL_MARGIN, SCROLL_MARGIN);
            parent.scrollRectToVisible(shown);
        }
    }

    /** Returns the controls in a container, except for those of actions, which are enabled by their actions. */
    private static Stream<Component> controlsIn(Container container) {
        return Stream.of(container.getComponents())
                .flatMap(part -> part instanceof JSpinner
                                || part instanceof JComboBox
                                || part instanceof AbstractButton button && button.getAction() == null
                        ? Stream.of(part)
                        : part instanceof Container inner ? controlsIn(inner) : Stream.empty());
    }

    /** Returns a world in which the sensors of the default robot see nothing. */
    private static Snapshot emptyWorld() {
        WorldSpec nothing = new WorldSpec(1, 1, false, 0, List.of());
        World world = new World(nothing, RobotSpec.DEFAULT, new Pose(0, 0, 0), SimulationSetup.DEFAULT_TICK, 0);
        world.sense();
        return world.snapshot();
    }

    /** Scrolls the tab that shows, which may have no control that a key could reach. */
    private void scrollByPage(int direction) {
        if (tabs.getSelectedComponent() instanceof JScrollPane scroll) {
            JScrollBar bar = scroll.getVerticalScrollBar();
            bar.setValue(bar.getValue() + direction * bar.getBlockIncrement(direction));
        }
    }

    /** Adds a tab with the key of its name and its sections from top to bottom. */
    public void addTab(String key, JComponent... sections) {
        addTab(key, createColumn(sections));
    }

    private static JPanel createColumn(JComponent... sections) {
        JPanel column = new JPanel();
        column.setLayout(new BoxLayout(column, BoxLayout.PAGE_AXIS));
        for (JComponent section : sections) {
            column.add(section);
        }
        return column;
    }

    /** Adds a section with the key of its heading below all others of the tab of the robot. */
    public void addRobotSection(String key, JComponent section) {
        robotTab.add(new TitledSection(key, section));
    }

    private void addTab(String key, JPanel column) {
        JPanel top = new NarrowingColumn();
        top.add(column, BorderLayout.NORTH);
        JScrollPane scroll =
                new JScrollPane(
                        top,
                        ScrollPaneConstants.VERTICAL_SCROLLBAR_ALWAYS,
                        ScrollPaneConstants.HORIZONTAL_SCROLLBAR_AS_NEEDED) {
                    /** Returns a size no higher than that of the first tab; longer tabs scroll. */
                    @Override
                    public Dimension getPreferredSize() {
                        Dimension size = super.getPreferredSize();
                        Component first = tabs.getComponentAt(0);
                        return first == this
                                ? size
                                : new Dimension(size.width, Math.min(size.height, first.getPreferredSize().height));
                    }

                    /** Moves the focus from a tab that was left to the title of this one, not to its first field. */
                    @Override
                    @SuppressWarnings("deprecation") // Called by the tabs if they cannot focus this component.
                    public boolean requestDefaultFocus() {
                        return tabs.requestFocusInWindow();
                    }
                };
        scroll.setFocusable(false);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        UiText.addTab(tabs, key, scroll);
    }

    /** Returns a width at which the sections scroll sideways. */
    @Override
    public Dimension getMinimumSize() {
        return new Dimension(MIN_WIDTH, super.getMinimumSize().height);
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(defaultWidth(), super.getPreferredSize().height);
    }

    /** Returns the width in pixels that fits the sensor rows and the scroll bar, even before they exist. */
    public int defaultWidth() {
        return TextSize.scaled(WIDTH);
    }

    /** Returns the fields of the selected sensor with its faults. */
    public JComponent sensorDetails() {
        return sensorDetails;
    }

    /** Returns the panel of the run with the health of the sensors. */
    public JComponent runPanel() {
        return run;
    }

    /** Gives the selected sensor the id that it has in the next snapshot, as returned for the present one. */
    public void renameSensors(UnaryOperator<String> presentId) {
        sensors.renameSensors(presentId);
        sensorDetails.renameSensors(presentId);
    }

    /** Shows the state of a world without a timeline. */
    public void setSnapshot(Snapshot world) {
        setSnapshot(world, List.of());
    }

    /** Shows the state of a world, given the timeline of its run; the same list as before if it is equal. */
    public void setSnapshot(Snapshot world, List<TimedCommand> timeline) {
        assert EventQueue.isDispatchThread();
        disabledControls.forEach(control -> control.setEnabled(true));
        disabledControls = List.of();
        sender.pendingEdits().setRobot(world.robot());
        robot.setRobot(sender.pendingEdits().robot());
        sensors.setSensors(world.sensors());
        sensorDetails.setSensors(world.sensors(), timeline, world.time());
    }

    /** Shows the result of a run so far. */
    public void setRun(SessionFrame frame, SessionStatus status, Scenario scenario) {
        controller.setSettings(frame.controller(), frame.controllerName(), scenario.setup());
        run.setRun(frame, status, scenario);
    }

    /** Shows the name or the command of the controller that the user has chosen for the run; empty for none. */
    public void setChosenController(String text) {
        controller.setChosen(text);
    }

    /** Commits what is being typed, as if the field lost the focus, and returns whether that changed a value. */
    public boolean commitPendingEdit() {
        return focusedField().filter(PendingField::commitPendingEdit).isPresent();
    }

    /** Takes back what is being typed and has not been applied; returns whether there was something. */
    public boolean undoTyping() {
        Optional<PendingField> typed = focusedField().filter(PendingField::isEdited);
        typed.ifPresent(PendingField::discardPendingEdit);
        return typed.isPresent();
    }

    /** Returns the field that has the focus, which it keeps while a menu or another window has it for a time. */
    private Optional<PendingField> focusedField() {
        Component owner = focusManager().getPermanentFocusOwner();
        Component field =
                owner instanceof PendingField ? owner : SwingUtilities.getAncestorOfClass(PendingField.class, owner);
        return field instanceof PendingField typed && isAncestorOf(field) ? Optional.of(typed) : Optional.empty();
    }

    /** Highlights the row of a sensor and shows its details. */
    public void selectSensor(String id) {
        sensors.selectSensor(id);
        sensorDetails.selectSensor(id);
    }

    /** Removes the highlight from the row of a sensor, whose details remain. */
    public void clearSensorSelection() {
        sensors.selectSensor(null);
    }

    private static Stream<PendingField> pendingFieldsIn(Container container) {
        return Stream.of(container.getComponents())
                .flatMap(part -> part instanceof PendingField field
                        ? Stream.of(field)
                        : part instanceof Container inner ? pendingFieldsIn(inner) : Stream.empty());
    }

    /**
     * Prepares for another scenario, whose first sensor will be selected. What is being typed was for the scenario
     * before.
     */
    public void startScenario() {
        pendingFieldsIn(this).forEach(PendingField::discardPendingEdit);
        sensorDetails.startScenario();
    }

    /** Adds a listener for the ids of sensors selected by the user. */
    public void addSelectionListener(Consumer<String> listener) {
        sensors.addSelectionListener(listener);
    }
}
