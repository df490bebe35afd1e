package faultline.gui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.GuiRobot;
import faultline.gui.form.NumberSpinner;
import faultline.gui.theme.Theme;
import faultline.gui.timeline.LaneView;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import faultline.world.Command;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JTextField;
import javax.swing.MenuSelectionManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** Faults drawn on the time line of a real window, with the mouse and with keys alone. The left sensor is the third. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class TimelineRobotTest {

    private static final String NEW_FAULT = "Fault";
    private static final Command INJECT = new Command.InjectFault("left", new Fault.Stuck(0.4));
    private static final Command CLEAR = new Command.ClearFault("left", new Fault.Stuck(0.4));

    @TempDir
    private Path folder;

    private Path file;
    private WindowDriver driver;
    private LanesDriver lanes;

    @BeforeEach
    void open() throws IOException {
        file = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("office.xml"));
        driver = WindowDriver.open(Theme.LIGHT, file);
        lanes = new LanesDriver(driver, 2);
    }

    @AfterEach
    void close() {
        driver.close();
    }

    /** Saves changes that the title shows, and returns the timeline of the file. */
    private List<TimedCommand> saved() throws ScenarioException {
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        driver.waitForTitle("office.xml");
        return Scenario.load(file).setup().timeline();
    }

    private static void assertTimeline(List<TimedCommand> timeline, double start, double end, double tolerance) {
        assertEquals(
                List.of(INJECT, CLEAR),
                timeline.stream().map(TimedCommand::command).toList());
        assertEquals(start, timeline.get(0).time(), tolerance);
        assertEquals(end, timeline.get(1).time(), tolerance);
    }

    @Test
    void aFaultDrawnInALaneIsSavedAndItsEndsCanBeDragged() throws ScenarioException {
        lanes.drag(20, 40);
        driver.clickButton(NEW_FAULT, "OK");
        driver.waitForTitle("office.xml*");
        assertTimeline(saved(), 20, 40, 1.5);
        lanes.drag(40, 90);
        driver.waitForTitle("office.xml*");
        assertTimeline(saved(), 20, 90, 1.5);
        lanes.drag(60, 100);
        driver.waitForTitle("office.xml*");
        assertTimeline(saved(), 60, 130, 2.5);
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        driver.waitForTitle("office.xml*");
        assertTimeline(saved(), 20, 90, 1.5);
    }

    @Test
    void everythingCanBeDoneWithKeys() throws ScenarioException {
        openNewFault();
        tabToStart();
        enterStart(KeyEvent.VK_5);
        driver.waitForTitle("office.xml*");
        List<TimedCommand> drawn = saved();
        assertEquals(5, drawn.get(0).time());
        driver.type(KeyEvent.VK_SHIFT, KeyEvent.VK_RIGHT);
        driver.waitForTitle("office.xml*");
        List<TimedCommand> longer = saved();
        assertEquals(5, longer.get(0).time());
        assertTrue(longer.get(1).time() > drawn.get(1).time());
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_D);
        driver.waitForTitle("office.xml*");
        assertEquals(4, saved().size());
        driver.type(KeyEvent.VK_DELETE);
        driver.waitForTitle("office.xml*");
        assertEquals(longer, saved());
    }

    @Test
    void aKeyOpensTheMenuOfALaneWithItsFirstItemSelected() {
        lanes.click(20);
        driver.type(KeyEvent.VK_SHIFT, KeyEvent.VK_F10);
        driver.robot().waitFor("the first item that is enabled is selected", () -> Stream.of(
                        MenuSelectionManager.defaultManager().getSelectedPath())
                .anyMatch(
                        part -> part instanceof JMenuItem item && item.getText().equals("New fault here…")));
        driver.robot().waitFor("the lane is still marked", this::isLaneMarked);
        driver.type(KeyEvent.VK_ENTER);
        driver.clickButton(NEW_FAULT, "Cancel");
    }

    /** Returns whether the left edge of the lanes has a mark. Event dispatch thread only. */
    private boolean isLaneMarked() {
        LaneView view = lanes.view();
        BufferedImage edge = new BufferedImage(1, view.getHeight(), BufferedImage.TYPE_INT_RGB);
        view.paint(edge.createGraphics());
        int accent = Theme.LIGHT.colours().accent().getRGB();
        return IntStream.range(0, edge.getHeight()).anyMatch(y -> edge.getRGB(0, y) == accent);
    }

    @Test
    void aFaultThatEndsBeforeItStartsIsRefusedWithTheReason() throws ScenarioException {
        openNewFault();
        tabToStart();
        enterStart(KeyEvent.VK_9, KeyEvent.VK_9);
        driver.robot().waitFor("the reason", () -> isShown("The end (\"Until\") must be after the start (\"From\")."));
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("the reason is gone", () -> !isShown("The end"));
        enterStart(KeyEvent.VK_5);
        driver.waitForTitle("office.xml*");
        assertEquals(5, saved().get(0).time());
        driver.robot().waitFor("the lanes have the focus again", lanes.view()::isFocusOwner);
        driver.type(KeyEvent.VK_DELETE);
        driver.waitForTitle("office.xml*");
        assertEquals(List.of(), saved());
    }

    @Test
    void theTimeThatWasChangedLastIsToBeCorrected() {
        openNewFault();
        NumberSpinner end = ComponentFinder.find(driver.dialog(NEW_FAULT), NumberSpinner.class, "Until");
        enterInto(end.textField(), KeyEvent.VK_0);
        driver.robot().waitFor("the reason", () -> isShown("The end (\"Until\") must be after the start (\"From\")."));
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("the end has the focus", end.textField()::isFocusOwner);
        driver.clickButton(NEW_FAULT, "Cancel");
    }

    @Test
    void anEndThatIsAddedToAFaultIsAfterItsStart() throws ScenarioException {
        openNewFault();
        JCheckBox ends = ComponentFinder.find(driver.dialog(NEW_FAULT), JCheckBox.class, "Until");
        driver.click(ends);
        enterInto(
                ComponentFinder.find(driver.dialog(NEW_FAULT), NumberSpinner.class, "From")
                        .textField(),
                KeyEvent.VK_5);
        driver.waitForTitle("office.xml*");
        assertEquals(1, saved().size());
        driver.type(KeyEvent.VK_ENTER);
        JDialog dialog = driver.dialog("Fault");
        driver.click(ComponentFinder.find(dialog, JCheckBox.class, "Until"));
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.waitForTitle("office.xml*");
        List<TimedCommand> withEnd = saved();
        assertEquals(2, withEnd.size());
        assertTrue(withEnd.get(1).time() > 5);
    }

    @Test
    void anInvalidPositionOfAMoveIsNotAccepted() throws ScenarioException, IOException {
        driver.close();
        String move = "<move at=\"90\" obstacle=\"copier\" x=\"5\" y=\"2\" heading=\"0\"/>";
        Files.writeString(file, Files.readString(file).replace("<expect", "<timeline>" + move + "</timeline><expect"));
        driver = WindowDriver.open(Theme.LIGHT, file);
        new LanesDriver(driver, 10).doubleClick(90);
        String title = "copier moved";
        JTextField x = ComponentFinder.find(driver.dialog(title), NumberSpinner.class, "Position x")
                .textField();
        enterInto(x, KeyEvent.VK_MINUS);
        driver.dialog(title);
        driver.robot().waitFor("the refused number has the focus", x::isFocusOwner);
        enterInto(x, KeyEvent.VK_4);
        driver.waitForTitle("office.xml*");
        assertEquals(
                new Command.MoveObstacle("copier", new Pose(4, 2, 0)),
                saved().get(0).command());
    }

    @Test
    void fieldsOfAFaultStayWhereTheyAreAfterAKindWithMoreOfThem() {
        openNewFault();
        Window dialog = driver.dialog(NEW_FAULT);
        JComboBox<?> kind = ComponentFinder.find(dialog, JComboBox.class, "Fault");
        int before = GuiRobot.callOnEdt(() -> kind.getY());
        int height = GuiRobot.callOnEdt(dialog::getHeight);
        GuiRobot.runOnEdt(() -> kind.setSelectedItem(FaultKind.BURSTS));
        driver.robot().waitFor("the dialog has grown", () -> dialog.getHeight() > height);
        GuiRobot.runOnEdt(() -> kind.setSelectedItem(FaultKind.BIAS));
        driver.robot().waitForPaint();
        assertEquals(before, GuiRobot.callOnEdt(() -> kind.getY()));
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
    }

    @Test
    void theChoiceOfTheSensorOfAFaultIsNotAsWideAsALongId() throws IOException {
        String id = "sensor-".repeat(14);
        String sensor = "><sensor id=\"" + id + "\" x=\"0.1\" y=\"0\" bearing=\"10\" range=\"0.5\"/></robot>";
        Path other = Files.writeString(
                folder.resolve("other.xml"), Files.readString(file).replaceFirst("(<robot [^>]*)/>", "$1" + sensor));
        GuiRobot.runOnEdt(() -> driver.window().open(other));
        driver.waitForTitle("other.xml");
        openNewFault();
        JComboBox<?> choice = ComponentFinder.find(driver.dialog(NEW_FAULT), JComboBox.class, "Sensor");
        assertEquals(9, GuiRobot.callOnEdt(choice::getItemCount));
        int width = GuiRobot.callOnEdt(choice::getWidth);
        assertTrue(width < 500, "it has a width of " + width);
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
    }

    private void enterInto(JTextField field, int key) {
        driver.click(field);
        driver.robot().waitFor("the field has the focus", field::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        driver.robot().pressKeys(key);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitForPaint();
    }

    /** Opens the dialog of a new fault of the left sensor by keys alone. */
    private void openNewFault() {
        driver.robot().waitFor("the canvas has the focus", () -> driver.canvas().isFocusOwner());
        driver.type(KeyEvent.VK_F6);
        driver.type(KeyEvent.VK_F6);
        driver.robot().waitFor("the lanes have the focus", lanes.view()::isFocusOwner);
        driver.type(KeyEvent.VK_DOWN);
        driver.type(KeyEvent.VK_DOWN);
        driver.type(KeyEvent.VK_ENTER);
    }

    /** Moves the focus from the kind of the fault, which is chosen first, over its number to the start. */
    private void tabToStart() {
        JComboBox<?> kind = ComponentFinder.find(driver.dialog(NEW_FAULT), JComboBox.class, "Fault");
        driver.robot().waitFor("the kind has the focus", kind::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_TAB);
        driver.robot().pressKeys(KeyEvent.VK_TAB);
    }

    private void enterStart(int... digits) {
        JTextField start = ComponentFinder.find(driver.dialog(NEW_FAULT), NumberSpinner.class, "From")
                .textField();
        driver.robot().waitFor("the start has the focus", start::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        for (int digit : digits) {
            driver.robot().pressKeys(digit);
        }
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
    }

    private static boolean isShown(String text) {
        return Arrays.stream(Window.getWindows())
                .filter(Window::isShowing)
                .flatMap(window -> ComponentFinder.findAll(window, JLabel.class))
                .anyMatch(label -> label.getText() != null && label.getText().startsWith(text));
    }
}
