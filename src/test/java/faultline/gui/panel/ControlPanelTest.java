package faultline.gui.panel;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SampleFrames;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.ComponentFinder;
import faultline.gui.FieldExtremes;
import faultline.gui.action.UiAction;
import faultline.gui.edit.CommandSender;
import faultline.gui.form.MutedLabel;
import faultline.gui.form.NumberSpinner;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.text.ReadingText;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.SensorSnapshot;
import faultline.world.Snapshot;
import faultline.world.WorldSpec;
import java.awt.Container;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import javax.swing.JSpinner;
import javax.swing.JTabbedPane;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JViewport;
import javax.swing.KeyStroke;
import javax.swing.ScrollPaneConstants;
import javax.swing.SpinnerNumberModel;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The control panel without a display, with a snapshot that contains every kind of state. */
class ControlPanelTest {

    /** By how many pixels the texts of a row are longer on a screen with scale 2, which rounds letters differently. */
    private static final int HIGH_RESOLUTION_RESERVE = 5;

    private final List<Command> commands = new ArrayList<>();
    private final List<Runnable> refusals = new ArrayList<>();
    private final Snapshot world = SampleFrames.fullFrame().snapshot();
    private final ControlPanel.PanelActions actions = new ControlPanel.PanelActions(
            UiAction.toggle("path", true, on -> {}),
            UiAction.of("chooseController", () -> {}),
            UiAction.of("scenarioController", () -> {}));
    private ControlPanel panel;

    private final List<String> sensorRequests = new ArrayList<>();
    private final ControlPanel.SensorEdits sensorEdits =
            new ControlPanel.SensorEdits(() -> sensorRequests.add("added"), sensorRequests::add, this::rename);

    @BeforeEach
    void show() {
        panel = callOnEdt(() -> {
            Theme.LIGHT.install();
            ControlPanel made = createPanel();
            made.setSnapshot(world);
            return made;
        });
    }

    @Test
    void theButtonsAddASensorAndRemoveTheChosenOne() {
        runOnEdt(() -> {
            ComponentFinder.find(panel, JComboBox.class, "Sensor").setSelectedItem("rear");
            ComponentFinder.find(panel, JButton.class, "Add a sensor").doClick(0);
            ComponentFinder.find(panel, JButton.class, "Delete this sensor").doClick(0);
        });
        assertEquals(List.of("added", "rear"), sensorRequests);
    }

    /** Records a request for another id, and refuses one that is taken. */
    private Optional<String> rename(String id, String newId) {
        sensorRequests.add(id + " > " + newId);
        return newId.equals("rear") ? Optional.of("taken") : Optional.empty();
    }

    private JTextField idField() {
        return ComponentFinder.find(panel, JTextField.class, "Id");
    }

    private void enterId(String text) {
        runOnEdt(() -> {
            idField().setText(text);
            idField().postActionEvent();
        });
    }

    @Test
    void theIdOfTheChosenSensorCanBeChanged() {
        runOnEdt(() -> panel.selectSensor("left"));
        assertEquals("left", callOnEdt(idField()::getText));
        enterId("rear");
        assertEquals("rear", callOnEdt(idField()::getText), "stays until it is corrected");
        enterId("  port \uFFFE side ");
        assertEquals("port side", callOnEdt(idField()::getText));
        enterId("port side");
        assertEquals(List.of("left > rear", "left > port side"), sensorRequests, "an unchanged id is no request");
    }

    @Test
    void whatIsTypedIsForTheSensorThatWasChosenBefore() {
        runOnEdt(() -> {
            panel.selectSensor("left");
            idField().setText("port");
            panel.selectSensor("right");
        });
        assertEquals(List.of("left > port"), sensorRequests);
        assertEquals("right", callOnEdt(idField()::getText));
    }

    /** It was for the sensors of the scenario before, which may have the same ids. */
    @Test
    void whatIsBeingTypedIsDiscardedWithItsScenario() {
        runOnEdt(() -> {
            panel.selectSensor("left");
            List<JTextField> fields = pendingTextFields();
            List<String> before = fields.stream().map(JTextField::getText).toList();
            fields.forEach(field -> field.setText("0.07"));
            panel.startScenario();
            panel.setSnapshot(world);
            panel.selectSensor("left");
            assertEquals(before, fields.stream().map(JTextField::getText).toList());
        });
        assertEquals(List.of(), sensorRequests);
        assertEquals(List.of(), commands);
    }

    /** Returns the fields of the tab of the robot that apply what is typed. */
    private List<JTextField> pendingTextFields() {
        Container robotTab = (Container) ComponentFinder.findAll(panel, JTabbedPane.class)
                .findFirst()
                .orElseThrow()
                .getComponentAt(0);
        List<JTextField> fields = Stream.concat(
                        NumberSpinner.findIn(robotTab)
                                .filter(NumberSpinner::isEnabled)
                                .map(NumberSpinner::textField),
                        Stream.of(idField()))
                .toList();
        assertTrue(fields.size() > world.sensors().size(), "the ranges of all sensors among them");
        return fields;
    }

    @Test
    void aRenamedSensorStaysChosen() {
        runOnEdt(() -> {
            panel.selectSensor("left");
            rename(Map.of("left", "port", "front", "bow"));
        });
        assertEquals("port", callOnEdt(idField()::getText));
        assertEquals("port", callOnEdt(() -> ComponentFinder.find(panel, JComboBox.class, "Sensor")
                .getSelectedItem()));
        assertEquals(List.of(), sensorRequests);
    }

    /** Shows the world with other ids of sensors, given those that differ. */
    private void rename(Map<String, String> ids) {
        UnaryOperator<String> presentId = id -> ids.getOrDefault(id, id);
        List<SensorSnapshot> sensors = world.sensors().stream()
                .map(SensorSnapshot::spec)
                .map(sensor -> sensor.withId(presentId.apply(sensor.id())))
                .map(sensor -> SampleFrames.sensor(sensor, world.pose(), SampleFrames.NOTHING))
                .toList();
        panel.renameSensors(presentId);
        panel.setSnapshot(SampleFrames.frameOf(
                        world.pose(), SampleFrames.pathThrough(world.pose().position()), sensors)
                .snapshot());
    }

    @Test
    void everyNumberThatAFieldAllowsCanBeSaved() {
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(6, 4, true, 3, List.of()), new Pose(3, 2, 0))
                .withRobot(world.robot());
        Container robotTab = callOnEdt(() -> (Container) ComponentFinder.findAll(panel, JTabbedPane.class)
                .findFirst()
                .orElseThrow()
                .getComponentAt(0));
        FieldExtremes.enterAll(robotTab, () -> FieldExtremes.save(setup, commands));
    }

    private ControlPanel createPanel() {
        return new ControlPanel(new CommandSender(this::execute), null, sensorEdits, actions);
    }

    /** Records commands, and how to refuse them. */
    private void execute(List<Command> sent, Consumer<List<CommandResult>> onExecuted) {
        commands.addAll(sent);
        refusals.add(() -> onExecuted.accept(List.of()));
    }

    @Test
    void everySensorHasASwitchThatStandsAsItDoes() {
        for (int i = 0; i < world.sensors().size(); i++) {
            String id = world.sensors().get(i).spec().id();
            assertEquals(
                    world.sensors().get(i).spec().on(),
                    callOnEdt(() -> switchOf(id).isSelected()),
                    id);
        }
    }

    @Test
    void aClickOnASwitchIsACommandAndShowsAtOnce() {
        runOnEdt(() -> switchOf("front").doClick(0));
        runOnEdt(() -> panel.setSnapshot(world));
        assertEquals(List.of(new Command.SwitchSensor("front", false)), commands);
        assertFalse(callOnEdt(() -> switchOf("front").isSelected()));
    }

    @Test
    void aSwitchThatTheWorldRefusesGoesBack() {
        runOnEdt(() -> switchOf("front").doClick(0));
        runOnEdt(() -> panel.setSnapshot(world));
        assertFalse(callOnEdt(() -> switchOf("front").isSelected()), "not answered yet");
        runOnEdt(refusals.get(0)::run);
        runOnEdt(() -> panel.setSnapshot(world));
        assertTrue(callOnEdt(() -> switchOf("front").isSelected()));
    }

    @Test
    void anInvalidFaultValueIsReportedAndNothingIsInjected() {
        runOnEdt(() -> {
            JTextField value = ComponentFinder.find(panel, JTextField.class, "Value");
            value.setText("1.2.3");
            injectButton().doClick(0);
        });
        assertEquals(List.of(), commands);
        assertTrue(callOnEdt(() -> isProblemShown("Invalid value. Allowed: ")));
        runOnEdt(() -> {
            ComponentFinder.find(panel, JTextField.class, "Value").setText("0.3");
            injectButton().doClick(0);
        });
        assertEquals(List.of(new Command.InjectFault("front", new Fault.Stuck(0.3))), commands);
    }

    @Test
    void aFirstRobotWithoutSensorsHasNothingToEdit() {
        runOnEdt(() -> {
            ControlPanel first = createPanel();
            first.startScenario();
            first.setSnapshot(SampleFrames.frameOf(new Pose(2, 1, 0)).snapshot());
            assertEquals(List.of(), enabledControls(first));
            first.setSnapshot(world);
            assertEquals(2, enabledControls(first).size());
        });
    }

    /** Returns the field for the bearing and the button for a fault, if they are enabled. */
    private static List<JComponent> enabledControls(JComponent parent) {
        return Stream.<JComponent>concat(
                        NumberSpinner.findIn(parent).filter(field -> ComponentFinder.accessibleName(field)
                                .startsWith("Bearing")),
                        Stream.of(injectButton(parent)))
                .filter(JComponent::isEnabled)
                .toList();
    }

    @Test
    void theListOfSensorsIsNotAsWideAsALongId() {
        SensorDetailsPanel details =
                callOnEdt(() -> new SensorDetailsPanel(new CommandSender(this::execute), sensorEdits));
        SensorSnapshot front = world.sensors().get(0);
        SensorSnapshot renamed = new SensorSnapshot(
                front.spec().withId("sensor-".repeat(14)),
                front.sector(),
                front.truth(),
                front.reported(),
                front.intersections(),
                front.faults());
        runOnEdt(() -> {
            details.setSensors(List.of(renamed), List.of(), 0);
            JComboBox<?> choice = ComponentFinder.find(details, JComboBox.class, "Sensor");
            int width = choice.getPreferredSize().width;
            assertTrue(width < 400, "it has a width of " + width);
        });
    }

    @Test
    void aRobotWithoutSensorsKeepsNoneOfTheScenarioBefore() {
        SensorDetailsPanel details =
                callOnEdt(() -> new SensorDetailsPanel(new CommandSender(this::execute), sensorEdits));
        runOnEdt(() -> {
            details.setSensors(world.sensors(), List.of(), 0);
            details.startScenario();
            details.setSensors(List.of(), List.of(), 0);
            assertEquals(List.of(), enabledControls(details));
            assertEquals(
                    0, ComponentFinder.find(details, JComboBox.class, "Sensor").getItemCount());
        });
    }

    private JButton injectButton() {
        return injectButton(panel);
    }

    private static JButton injectButton(JComponent parent) {
        return ComponentFinder.findAll(parent, JButton.class)
                .filter(button -> "Inject".equals(button.getText()))
                .findFirst()
                .orElseThrow();
    }

    /** A scenario may have a speed that its motors do not reach: it is shown, and kept until the user changes it. */
    @Test
    void theSpeedIsLimitedToThatOfTheMotors() {
        RobotSpec slow = RobotSpec.DEFAULT
                .withMotor(new MotorSpec(0.05, 0.04, 6))
                .withPlatform(RobotSpec.DEFAULT.length(), RobotSpec.DEFAULT.width(), 0.8);
        showRobot(slow);
        assertEquals(0.24, speedLimit(), 1e-15);
        assertEquals(
                "0.80", callOnEdt(() -> spinner("Linear velocity").textField().getText()));
        showRobot(slow.withMotor(new MotorSpec(0.05, 0.5, 6)));
        assertEquals(3, speedLimit(), 1e-15);
        assertEquals(List.of(), commands, "sent by the panel itself");
        showRobot(slow);
        runOnEdt(() -> spinner("Platform length").setValue(0.3));
        assertEquals(List.of(new Command.SetPlatform(0.3, slow.width(), 0.8)), commands);
    }

    private double speedLimit() {
        return callOnEdt(
                () -> (Double) ((SpinnerNumberModel) spinner("Linear velocity").getModel()).getMaximum());
    }

    /** Shows a world with another robot. */
    private void showRobot(RobotSpec robot) {
        Snapshot changed = new Snapshot(
                world.tick(),
                world.time(),
                world.width(),
                world.height(),
                world.enclosed(),
                robot,
                world.pose(),
                world.wheelSpeeds(),
                world.motorFaults(),
                world.sensors(),
                world.obstacles(),
                world.contacts(),
                world.collisions());
        runOnEdt(() -> panel.setSnapshot(changed));
    }

    @Test
    void withoutAScenarioNoFieldShowsItsLowerLimit() {
        runOnEdt(() -> {
            ControlPanel empty = new ControlPanel(new CommandSender(this::execute), null, sensorEdits, actions);
            assertEquals(
                    "0",
                    ComponentFinder.findAll(empty, JTextField.class)
                            .filter(field ->
                                    ComponentFinder.accessibleName(field).startsWith("Bearing"))
                            .findFirst()
                            .orElseThrow()
                            .getText());
        });
    }

    @Test
    void theFieldsOfTheDefaultRobotStandDisabledWhereTheyWillBe() {
        runOnEdt(() -> {
            ControlPanel early = new ControlPanel(new CommandSender(this::execute), null, sensorEdits, actions);
            early.setSize(early.defaultWidth(), 640);
            layOut(early);
            List<NumberSpinner> fields = NumberSpinner.findIn(early).toList();
            assertEquals(
                    List.of(), fields.stream().filter(NumberSpinner::isEnabled).toList());
            assertEquals("0.30", fields.get(0).textField().getText());
            List<Rectangle> before =
                    fields.stream().map(NumberSpinner::getBounds).toList();
            early.setSnapshot(world);
            layOut(early);
            assertEquals(fields, NumberSpinner.findIn(early).toList(), "the same fields");
            assertEquals(before, fields.stream().map(NumberSpinner::getBounds).toList());
            assertTrue(fields.get(0).isEnabled());
        });
        assertEquals(List.of(), commands);
    }

    @ParameterizedTest
    @CsvSource({"ENGLISH, NORMAL", "POLISH, NORMAL", "ENGLISH, LARGEST", "POLISH, LARGEST"})
    void noTabScrollsSidewaysInAnyLanguage(Language language, TextSize size) {
        runOnEdt(() -> {
            Messages.setLanguage(language);
            size.install();
        });
        try {
            show();
            runOnEdt(() -> {
                panel.setSize(panel.defaultWidth(), 640);
                layOut(panel);
                assertNoTabScrollsSideways();
            });
        } finally {
            runOnEdt(() -> {
                Messages.setLanguage(Language.ENGLISH);
                TextSize.NORMAL.install();
            });
        }
    }

    private void assertNoTabScrollsSideways() {
        ComponentFinder.findAll(panel, JScrollPane.class).forEach(scroll -> {
            assertEquals(ScrollPaneConstants.VERTICAL_SCROLLBAR_ALWAYS, scroll.getVerticalScrollBarPolicy());
            int content = scroll.getViewport().getView().getPreferredSize().width;
            int room = scroll.getViewport().getWidth();
            assertTrue(content + HIGH_RESOLUTION_RESERVE <= room, content + " pixels in " + room);
        });
    }

    @ParameterizedTest
    @CsvSource({"ENGLISH, NORMAL", "POLISH, NORMAL", "ENGLISH, LARGEST", "POLISH, LARGEST"})
    void theIdIsReadableAndNoTabScrollsSidewaysHoweverLongItIs(Language language, TextSize size) {
        runOnEdt(() -> {
            Messages.setLanguage(language);
            size.install();
        });
        try {
            show();
            for (int length = 5; length <= 100; length += length < 25 ? 1 : 25) {
                String id = "W".repeat(length);
                runOnEdt(() -> {
                    rename(Map.of("left", id));
                    panel.selectSensor(id);
                    panel.setSize(panel.defaultWidth(), 640);
                    layOut(panel);
                    layOut(panel);
                    JTextField field = idField();
                    Insets insets = field.getInsets();
                    int room = field.getWidth() - insets.left - insets.right;
                    int text = field.getFontMetrics(field.getFont()).stringWidth("infrared");
                    assertTrue(room >= text, "8 letters of an id of " + id.length() + " in " + room + " pixels");
                    assertNoTabScrollsSideways();
                });
            }
        } finally {
            runOnEdt(() -> {
                Messages.setLanguage(Language.ENGLISH);
                TextSize.NORMAL.install();
            });
        }
    }

    @Test
    void aFieldThatGetsTheFocusScrollsIntoViewWithItsFrame() {
        runOnEdt(() -> {
            panel.setSize(panel.defaultWidth(), 300);
            layOut(panel);
            JSpinner last = ComponentFinder.findAll(panel, JSpinner.class)
                    .filter(JSpinner::isEnabled)
                    .reduce((first, second) -> second)
                    .orElseThrow();
            JViewport viewport = (JViewport) SwingUtilities.getAncestorOfClass(JViewport.class, last);
            assertEquals(0, viewport.getViewPosition().y);
            ControlPanel.scrollTo(((JSpinner.DefaultEditor) last.getEditor()).getTextField());
            assertTrue(viewport.getViewPosition().y > 0, "it was out of view");
            Rectangle shown = SwingUtilities.convertRectangle(last.getParent(), last.getBounds(), viewport);
            assertTrue(new Rectangle(viewport.getSize()).contains(shown), shown + " in " + viewport.getSize());
        });
    }

    @Test
    void pageKeysScrollTheTabWhoseTitleHasTheFocus() {
        runOnEdt(() -> {
            panel.setSize(panel.defaultWidth(), 300);
            layOut(panel);
            JTabbedPane tabs = ComponentFinder.findAll(panel, JTabbedPane.class)
                    .findFirst()
                    .orElseThrow();
            JViewport shown = ((JScrollPane) tabs.getSelectedComponent()).getViewport();
            pressKey(tabs, "PAGE_DOWN");
            assertTrue(shown.getViewPosition().y > 100, "y " + shown.getViewPosition().y);
            pressKey(tabs, "PAGE_UP");
            assertEquals(0, shown.getViewPosition().y);
        });
    }

    private static void pressKey(JComponent focused, String key) {
        Object action = focused.getInputMap().get(KeyStroke.getKeyStroke(key));
        focused.getActionMap().get(action).actionPerformed(new ActionEvent(focused, 0, key));
    }

    @Test
    void theHeadingsOfANarrowPanelStandAboveTheirValues() {
        runOnEdt(TextSize.LARGEST::install);
        try {
            show();
            runOnEdt(() -> {
                panel.setSize(336, 560);
                layOut(panel);
                layOut(panel);
                int[] fields = {
                    leftOf(JSpinner.class, "Range of front, metres"),
                    leftOf(JSpinner.class, "Cone of front, degrees"),
                    leftOf(ReadingBar.class, "True reading of front"),
                    leftOf(ReadingBar.class, "Reported reading of front")
                };
                int[] headings = Stream.of("Range, m", "Cone, °", "True, m", "Reported, m")
                        .mapToInt(name -> leftOf(MutedLabel.class, name))
                        .toArray();
                assertArrayEquals(fields, headings);
                assertTrue(fields[2] < fields[1], "one line");
            });
        } finally {
            runOnEdt(TextSize.NORMAL::install);
        }
    }

    private int leftOf(Class<? extends JComponent> type, String name) {
        return ComponentFinder.find(panel, type, name).getX();
    }

    @Test
    void theKeysThatSwitchTabsWorkFromAField() {
        runOnEdt(() -> {
            JTabbedPane tabs = ComponentFinder.findAll(panel, JTabbedPane.class)
                    .findFirst()
                    .orElseThrow();
            JTextField value = ComponentFinder.find(panel, JTextField.class, "Value");
            SwingUtilities.processKeyBindings(new KeyEvent(
                    value,
                    KeyEvent.KEY_PRESSED,
                    0,
                    InputEvent.CTRL_DOWN_MASK,
                    KeyEvent.VK_PAGE_DOWN,
                    KeyEvent.CHAR_UNDEFINED));
            assertEquals(1, tabs.getSelectedIndex());
        });
    }

    @Test
    void theFaultFieldsAreVisibleOnAScreenOf1366By768() {
        runOnEdt(() -> {
            panel.setSize(panel.defaultWidth(), 640);
            layOut(panel);
            JButton inject = injectButton();
            int bottom = SwingUtilities.convertPoint(inject, 0, inject.getHeight(), panel).y;
            assertTrue(bottom <= 630, "bottom of the button at " + bottom);
        });
    }

    private static void layOut(Container container) {
        container.doLayout();
        Stream.of(container.getComponents())
                .filter(Container.class::isInstance)
                .map(Container.class::cast)
                .forEach(ControlPanelTest::layOut);
    }

    @Test
    void rangeAndConeSetOneAfterTheOtherBothArrive() {
        runOnEdt(() -> {
            spinner("Range of left, metres").setValue(1.5);
            spinner("Cone of left, degrees").setValue(90.0);
        });
        Command.ConfigureSensor last = (Command.ConfigureSensor) commands.get(1);
        assertEquals(1.5, last.sensor().range());
        assertEquals(Math.PI / 2, last.sensor().cone(), 1e-15);
        assertEquals(
                world.sensors().get(2).spec().mountPosition(), last.sensor().mountPosition());
    }

    @Test
    void thePlatformIsSetAsAWhole() {
        runOnEdt(() -> {
            spinner("Linear velocity").setValue(0.5);
            spinner("Platform length").setValue(0.3);
        });
        assertEquals(new Command.SetPlatform(0.3, RobotSpec.DEFAULT.width(), 0.5), commands.get(1));
    }

    @Test
    void readingsAreNumbersDashesOrOff() {
        assertEquals(List.of("0.240", "–", "0.400", "–", "off", "off", "–", "–"), readings("Reported reading of "));
    }

    @Test
    void whatIsReallyThereStandsBesideWhatIsReported() {
        List<String> expected = world.sensors().stream()
                .map(sensor -> ReadingText.format(sensor.truth()))
                .toList();
        assertEquals(expected, readings("True reading of "));
        assertNotEquals(expected, readings("Reported reading of "));
    }

    private List<String> readings(String name) {
        return callOnEdt(() -> ComponentFinder.findAll(panel, ReadingBar.class)
                .filter(bar -> ComponentFinder.accessibleName(bar).startsWith(name))
                .map(ReadingBar::text)
                .toList());
    }

    /** They read the name before. */
    @Test
    void theDescriptionOfAReadingIsItsValue() {
        runOnEdt(() -> ComponentFinder.findAll(panel, ReadingBar.class).forEach(bar -> {
            String name = bar.getAccessibleContext().getAccessibleName();
            String description = bar.getAccessibleContext().getAccessibleDescription();
            assertTrue(description.startsWith(bar.text()), description);
            assertEquals(name + ": " + description, bar.getToolTipText());
        }));
    }

    @Test
    void theMountOfTheChosenSensorCanBeSet() {
        runOnEdt(() -> {
            panel.selectSensor("left");
            spinner(Messages.get("mount.bearing.tip")).setValue(80.0);
            spinner(Messages.get("mount.noise.tip")).setValue(0.004);
            spinner(Messages.get("mount.forward.tip")).setValue(0.05);
            spinner(Messages.get("mount.left.tip")).setValue(0.08);
        });
        SensorSpec left = world.sensors().get(2).spec();
        assertEquals(
                new Command.ConfigureSensor(left.withBearing(Math.toRadians(80))
                        .withNoise(0.004)
                        .withMountPosition(new Vector2(0.05, 0.08))),
                commands.get(3));
    }

    @Test
    void whatTwoControlsSetOfOneSensorBothArrives() {
        runOnEdt(() -> {
            panel.selectSensor("left");
            spinner("Range of left, metres").setValue(1.5);
            spinner(Messages.get("mount.noise.tip")).setValue(0.004);
        });
        assertEquals(
                new Command.ConfigureSensor(
                        world.sensors().get(2).spec().withRange(1.5).withNoise(0.004)),
                commands.get(1));
    }

    @Test
    void theFieldsShowTheChosenSensor() {
        runOnEdt(() -> panel.selectSensor("front-left"));
        assertEquals("front-left", callOnEdt(() -> ComponentFinder.find(panel, JComboBox.class, "Sensor")
                .getSelectedItem()));
        assertEquals(
                45, callOnEdt(() -> spinner(Messages.get("mount.bearing.tip")).doubleValue()), 1e-12);
    }

    @Test
    void aSensorChosenByNameIsMarkedToo() {
        List<String> selected = new ArrayList<>();
        runOnEdt(() -> {
            panel.addSelectionListener(selected::add);
            ComponentFinder.find(panel, JComboBox.class, "Sensor").setSelectedItem("rear");
        });
        assertEquals(List.of("rear"), selected);
    }

    @Test
    void whatIsBeingTypedGoesToTheSensorThatItWasTypedFor() {
        runOnEdt(() -> {
            panel.selectSensor("left");
            spinner(Messages.get("mount.bearing.tip")).textField().setText("75");
            panel.selectSensor("front");
        });
        assertEquals(
                List.of(new Command.ConfigureSensor(
                        world.sensors().get(2).spec().withBearing(Math.toRadians(75)))),
                commands);
    }

    @Test
    void aFaultyReadingSaysSoInWords() {
        assertEquals("Reported reading of left: 0.400 (faulty: stuck 0.40 m)", callOnEdt(() -> ComponentFinder.find(
                        panel, ReadingBar.class, "Reported reading of left")
                .getToolTipText()));
    }

    @Test
    void activeFaultsAreListedAndEachCanBeCleared() {
        List<String> texts = callOnEdt(() -> ComponentFinder.findAll(panel, JLabel.class)
                .map(JLabel::getText)
                .toList());
        assertTrue(texts.containsAll(List.of("left:", "stuck 0.40 m")), texts.toString());
        runOnEdt(() -> ComponentFinder.find(panel, JButton.class, "Repair left: stuck 0.40 m")
                .doClick(0));
        assertEquals(List.of(new Command.ClearFault("left", new Fault.Stuck(0.4))), commands);
    }

    @Test
    void everyKindOfFaultCanBeInjectedWithItsDefaultValue() {
        runOnEdt(() -> ComponentFinder.find(panel, JComboBox.class, "Sensor").setSelectedItem("rear"));
        for (FaultKind kind : FaultKind.values()) {
            runOnEdt(() -> {
                ComponentFinder.find(panel, JComboBox.class, "Fault").setSelectedItem(kind);
                ComponentFinder.find(panel, JButton.class, "Inject").doClick(0);
            });
        }
        List<Command> expected = new ArrayList<>();
        for (FaultKind kind : FaultKind.values()) {
            expected.add(new Command.InjectFault("rear", kind.createFault(kind.defaultValue())));
        }
        assertEquals(expected, commands);
    }

    private JCheckBox switchOf(String id) {
        return ComponentFinder.find(panel, JCheckBox.class, "Switch " + id + " on or off");
    }

    private NumberSpinner spinner(String name) {
        return ComponentFinder.find(panel, NumberSpinner.class, name);
    }

    @Test
    void aDistanceBeyondTheRangeOfTheSensorIsAllowedWithAWarning() {
        double range = world.sensors().get(0).spec().range();
        assertFalse(callOnEdt(this::isRangeWarned));
        runOnEdt(() -> spinner("Value").setValue(range + 0.1));
        assertTrue(callOnEdt(this::isRangeWarned));
        runOnEdt(() -> injectButton().doClick(0));
        assertEquals(List.of(new Command.InjectFault("front", new Fault.Stuck(range + 0.1))), commands);
        runOnEdt(() -> spinner("Value").setValue(range));
        assertFalse(callOnEdt(this::isRangeWarned));
    }

    private boolean isRangeWarned() {
        return isProblemShown("More than the range of the sensor, ");
    }

    private boolean isProblemShown(String start) {
        return ComponentFinder.findAll(panel, JTextArea.class)
                .anyMatch(text -> text.getParent().isVisible() && text.getText().startsWith(start));
    }
}
