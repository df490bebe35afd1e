package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Sector;
import faultline.geometry.Vector2;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import faultline.gui.timeline.LaneView;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;
import faultline.world.SensorSnapshot;
import java.awt.Component;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/** The context menu of a cone switches its sensor, adds a fault to it, repairs, copies and deletes it. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class SensorMenuRobotTest {

    private WindowDriver driver;

    @BeforeEach
    void open() {
        driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/office.xml"));
    }

    @AfterEach
    void close() {
        driver.close();
    }

    private static SensorSnapshot left(Frame frame) {
        return frame.snapshot().sensors().stream()
                .filter(sensor -> sensor.spec().id().equals("left"))
                .findFirst()
                .orElseThrow();
    }

    private void openMenu() {
        Sector cone = left(driver.frame()).sector();
        Vector2 at = callOnEdt(() ->
                driver.canvas().camera().toScreen(cone.apex().plus(cone.axis().times(0.7 * cone.range()))));
        driver.robot().click(driver.canvas(), at.x(), at.y(), InputEvent.BUTTON3_DOWN_MASK);
        driver.robot().waitFor("the menu shows", () -> WindowDriver.popupItems()
                .findAny()
                .isPresent());
    }

    private static JMenuItem item(String text) {
        return callOnEdt(() -> WindowDriver.popupItems()
                .filter(item -> item.getText().equals(text))
                .findFirst()
                .orElseThrow());
    }

    private void choose(String text) {
        openMenu();
        driver.click(item(text));
    }

    @Test
    void theSensorIsSwitchedOffAndOn() {
        choose("Switch off left");
        driver.waitForFrame("it is off", frame -> !left(frame).spec().on());
        choose("Switch on left");
        driver.waitForFrame("it is on again", frame -> left(frame).spec().on());
    }

    @Test
    void aKeyOpensTheMenuWithItsFirstItemSelected() {
        runOnEdt(() -> driver.canvas().tools().selectSensor("left"));
        driver.robot().pressKeys(KeyEvent.VK_SHIFT, KeyEvent.VK_F10);
        driver.robot().waitFor("the menu shows", () -> WindowDriver.popupItems()
                .findAny()
                .isPresent());
        JMenuItem first = item("Switch off left");
        driver.robot().waitFor("its first item is selected", first::isArmed);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.waitForFrame("it is off", frame -> !left(frame).spec().on());
    }

    private static List<String> ids(Frame frame) {
        return frame.snapshot().robot().sensorIds();
    }

    @Test
    void aSensorIsDuplicatedAndDeletedAndBothAreUndone() {
        choose("Duplicate left");
        driver.waitForFrame("the copy", frame -> ids(frame).contains("left-2"));
        driver.robot().waitFor("it is selected", () -> selectedSensor().equals(Optional.of("left-2")));
        assertEquals("left-2", callOnEdt(() -> sensorChoice().getSelectedItem()));
        runOnEdt(() -> driver.canvas().requestFocusInWindow());
        driver.robot().pressKeys(KeyEvent.VK_DELETE);
        driver.waitForFrame("no copy", frame -> !ids(frame).contains("left-2"));
        choose("Delete left");
        driver.waitForFrame("seven sensors", frame -> ids(frame).size() == 7);
        List<String> left = ids(driver.frame());
        List<String> named = IntStream.rangeClosed(1, 7)
                .mapToObj(i -> "Sensor " + i + ": " + left.get(i - 1))
                .toList();
        driver.robot()
                .waitFor("the menu lists seven sensors", () -> shownSwitches().equals(named));
        driver.choose("undo");
        driver.waitForFrame("left again", frame -> ids(frame).indexOf("left") == 2);
        driver.robot().waitFor("the restored sensor is selected", () -> selectedSensor()
                .equals(Optional.of("left")));
        driver.choose("undo");
        driver.waitForFrame("the copy again", frame -> ids(frame).indexOf("left-2") == 8);
        driver.choose("undo");
        driver.waitForFrame("eight sensors", frame -> ids(frame).size() == 8);
        driver.waitForTitle("office.xml");
    }

    /** The run is simulated again once, so that the next frame has both ids. */
    @Test
    void theSelectionAndTheChartFollowTwoRenamingsInQuickSuccession() {
        JComboBox<?> signals = ComponentFinder.find(driver.window(), JComboBox.class, "Signals");
        runOnEdt(() -> {
            IntStream.range(0, signals.getItemCount())
                    .filter(i -> signals.getItemAt(i).toString().equals("Sensor left"))
                    .forEach(signals::setSelectedIndex);
            renameTo("bow", "front");
            renameTo("port", "left");
            sensorChoice().setSelectedItem("left");
        });
        driver.waitForFrame("both", frame -> ids(frame).containsAll(List.of("bow", "port")));
        driver.robot()
                .waitFor("the chart", () -> signals.getSelectedItem().toString().equals("Sensor port"));
        assertEquals(Optional.of("port"), callOnEdt(this::selectedSensor));
        assertEquals("port", callOnEdt(() -> sensorChoice().getSelectedItem()));
    }

    private void renameTo(String newId, String id) {
        sensorChoice().setSelectedItem(id);
        JTextField field = ComponentFinder.find(driver.window(), JTextField.class, "Id");
        field.setText(newId);
        field.postActionEvent();
    }

    /** Returns the names of the items of Simulation > Switch sensor that show. */
    private List<String> shownSwitches() {
        JMenuBar bar = driver.window().getJMenuBar();
        JMenu menu = IntStream.range(0, bar.getMenuCount())
                .mapToObj(bar::getMenu)
                .flatMap(each -> Stream.of(each.getMenuComponents()))
                .filter(part ->
                        part instanceof JMenu submenu && submenu.getText().equals("Switch sensor"))
                .map(JMenu.class::cast)
                .findFirst()
                .orElseThrow();
        return Stream.of(menu.getMenuComponents())
                .filter(Component::isVisible)
                .map(item -> ((JMenuItem) item).getText())
                .toList();
    }

    @Test
    void aSensorIsAddedInTheDirectionOfTheClickOnTheRobot() {
        Pose robot = driver.frame().snapshot().pose();
        Vector2 at = callOnEdt(() -> driver.canvas().camera().toScreen(robot.toParent(new Vector2(-0.03, -0.03))));
        driver.robot().click(driver.canvas(), at.x(), at.y(), InputEvent.BUTTON3_DOWN_MASK);
        driver.robot().waitFor("the menu shows", () -> WindowDriver.popupItems()
                .findAny()
                .isPresent());
        driver.click(item("Add sensor"));
        driver.waitForFrame("nine sensors", frame -> ids(frame).size() == 9);
        SensorSpec added = driver.frame().snapshot().sensors().get(8).spec();
        assertEquals("sensor-9", added.id());
        assertEquals(-135, Math.toDegrees(added.bearing()), 20);
        driver.robot().waitFor("it is selected", () -> selectedSensor().equals(Optional.of("sensor-9")));
        driver.choose("duplicate");
        driver.waitForFrame("a copy of it", frame -> ids(frame).contains("sensor-2"));
    }

    @Test
    void theRightButtonTurnsTheSelectedSensorAndOpensNoMenu() {
        runOnEdt(() -> driver.canvas().tools().selectSensor("left"));
        Sector cone = left(driver.frame()).sector();
        double distance = 0.7 * cone.range();
        Vector2 wanted = Vector2.direction(cone.axis().angle() + Degrees.toRadians(40));
        Vector2 from = toScreen(cone.apex().plus(cone.axis().times(distance)));
        Vector2 to = toScreen(cone.apex().plus(wanted.times(distance)));
        driver.robot().drag(driver.canvas(), from.x(), from.y(), to.x(), to.y(), InputEvent.BUTTON3_DOWN_MASK);
        driver.waitForFrame(
                "it is turned",
                frame -> Math.abs(Math.toDegrees(left(frame).spec().bearing()) - 130) < 5);
        assertEquals(0, callOnEdt(() -> WindowDriver.popupItems().count()));
        driver.choose("undo");
        driver.waitForFrame("it is as before", frame -> left(frame)
                .spec()
                .equals(RobotSpec.DEFAULT.sensor("left").orElseThrow()));
        driver.waitForTitle("office.xml");
    }

    private Vector2 toScreen(Vector2 point) {
        return callOnEdt(() -> driver.canvas().camera().toScreen(point));
    }

    private Optional<String> selectedSensor() {
        return driver.canvas().tools().selectedSensor();
    }

    private JComboBox<?> sensorChoice() {
        return ComponentFinder.find(driver.window(), JComboBox.class, "Sensor");
    }

    @Test
    void aFaultIsAddedInItsLaneWhichShowsAndIsRepaired() {
        LaneView lanes = ComponentFinder.findAll(driver.window(), LaneView.class)
                .findFirst()
                .orElseThrow();
        openMenu();
        JMenuItem repair = item("Repair left");
        assertFalse(callOnEdt(repair::isEnabled), "it has no fault");
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        if (callOnEdt(lanes::isShowing)) {
            driver.choose("timeline");
        }
        choose("Add a fault of left…");
        driver.clickButton("Fault", "OK");
        driver.robot().waitFor("the lanes show", lanes::isShowing);
        driver.waitForTitle("office.xml*");
        runOnEdt(() -> driver.canvas().requestFocusInWindow());
        driver.choose("step");
        driver.waitForFrame(
                "the fault is active", frame -> !left(frame).faults().isEmpty());
        assertEquals(List.of(new Fault.Stuck(0.4)), left(driver.frame()).faults());
        choose("Repair left");
        driver.waitForFrame("it is repaired", frame -> left(frame).faults().isEmpty());
        assertTrue(left(driver.frame()).spec().on());
    }
}
