package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Vector2;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import faultline.robot.MotorFault;
import faultline.robot.MotorFaults;
import faultline.robot.MotorSide;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.world.Command;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JMenuItem;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** Motors are broken and repaired by the control panel and by the context menu of the robot, paused and running. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class MotorFaultsRobotTest {

    private static final MotorFaults LEFT_WEAK = new MotorFaults(List.of(new MotorFault.Weak(0.7)), List.of());
    private static final String REPAIR = "Repair left motors: weak 0.70";
    private static final MotorFaults RIGHT_DEAD = new MotorFaults(List.of(), List.of(new MotorFault.NoDrive()));

    @TempDir
    private Path folder;

    private Path file;
    private WindowDriver driver;

    @BeforeEach
    void open() throws IOException {
        file = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("office.xml"));
        driver = WindowDriver.open(Theme.LIGHT, file);
    }

    @AfterEach
    void close() {
        driver.close();
    }

    private void waitForFaults(MotorFaults expected) {
        driver.waitForFrame(
                "the motors have " + expected, frame -> faults(frame).equals(expected));
    }

    private static MotorFaults faults(Frame frame) {
        return frame.snapshot().motorFaults();
    }

    private void clickInPanel(String name) {
        driver.robot().waitFor(name, () -> ComponentFinder.findAll(driver.window(), JButton.class)
                .anyMatch(button -> name.equals(ComponentFinder.accessibleName(button))));
        JButton button = ComponentFinder.find(driver.window(), JButton.class, name);
        runOnEdt(() -> ((JComponent) button.getParent()).scrollRectToVisible(button.getBounds()));
        driver.click(button);
    }

    private void chooseInMenuOfRobot(String text) {
        openMenu();
        driver.click(item(text));
    }

    private void openMenu() {
        Vector2 robot = driver.frame().snapshot().pose().position();
        Vector2 at = callOnEdt(() -> driver.canvas().camera().toScreen(robot));
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

    @Test
    void aRunningRobotGetsAFaultThatUndoRemovesAndTheListRepairs() {
        driver.choose("run");
        clickInPanel("Add a fault of the left motors");
        driver.clickButton("Fault of the left motors", "OK");
        waitForFaults(LEFT_WEAK);
        assertTrue(driver.isRunning());
        driver.choose("undo");
        waitForFaults(MotorFaults.NONE);
        driver.choose("redo");
        waitForFaults(LEFT_WEAK);
        clickInPanel(REPAIR);
        waitForFaults(MotorFaults.NONE);
        assertTrue(driver.isRunning());
    }

    @Test
    void theKeyboardAloneChoosesTheKindAndSaveKeepsTheFault() throws ScenarioException {
        clickInPanel("Add a fault of the right motors");
        JDialog dialog = driver.dialog("Fault of the right motors");
        JComboBox<?> kind = ComponentFinder.find(dialog, JComboBox.class, "Fault");
        driver.robot().waitFor("the kind has the focus", kind::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_DOWN);
        driver.robot().waitFor("the list shows", kind::isPopupVisible);
        driver.robot().pressKeys(KeyEvent.VK_DOWN);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("dead is chosen", () -> kind.getSelectedIndex() == 1 && !kind.isPopupVisible());
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        waitForFaults(RIGHT_DEAD);
        driver.waitForTitle("office.xml*");
        driver.choose("save");
        driver.waitForTitle("office.xml");
        List<Command> saved = Scenario.load(file).setup().timeline().stream()
                .map(TimedCommand::command)
                .toList();
        assertTrue(
                saved.contains(new Command.InjectMotorFault(MotorSide.RIGHT, new MotorFault.NoDrive())),
                saved.toString());
    }

    @Test
    void theMenuOfTheRobotBreaksAndRepairsTheMotorsOfAPausedRun() {
        openMenu();
        assertFalse(callOnEdt(item("Repair the left motors")::isEnabled), "they have no fault");
        driver.click(item("Add a fault of the left motors…"));
        driver.clickButton("Fault of the left motors", "OK");
        waitForFaults(LEFT_WEAK);
        chooseInMenuOfRobot("Repair the left motors");
        waitForFaults(MotorFaults.NONE);
        driver.robot().waitFor("the repair can be undone", () -> "Undo Repair left motors"
                .equals(driver.window().actions().get("undo").name()));
    }

    @Test
    void theFocusStaysInTheListAsLongAsItHasFaults() {
        for (int count = 1; count <= 2; count++) {
            addWeakFault(count);
        }
        JButton first = ComponentFinder.find(driver.window(), JButton.class, REPAIR);
        runOnEdt(first::requestFocusInWindow);
        driver.robot().waitFor("the list has the focus", first::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        waitForFaults(LEFT_WEAK);
        driver.robot().waitFor("the other row has the focus", () -> repairButtons()
                .anyMatch(button -> button != first && button.isFocusOwner()));
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        waitForFaults(MotorFaults.NONE);
        driver.robot()
                .waitFor(
                        "the button before has the focus",
                        ComponentFinder.find(driver.window(), JButton.class, "Add a fault of the right motors")
                                ::isFocusOwner);
    }

    /** The repair is on the timeline of the scenario at the time of the next tick, but the run has executed it. */
    @Test
    void theRepairOfOneOfTwoFaultsDoesNotEndTheOtherOne() {
        for (int count = 1; count <= 2; count++) {
            addWeakFault(count);
        }
        clickInPanel(REPAIR);
        waitForFaults(LEFT_WEAK);
        driver.robot().waitFor("one fault is listed", () -> repairButtons().count() == 1);
        assertFalse(WindowDriver.text(driver.window()).contains("s left"));
    }

    private void addWeakFault(int count) {
        clickInPanel("Add a fault of the left motors");
        driver.clickButton("Fault of the left motors", "OK");
        waitForFaults(new MotorFaults(Collections.nCopies(count, new MotorFault.Weak(0.7)), List.of()));
    }

    private Stream<JButton> repairButtons() {
        return ComponentFinder.findAll(driver.window(), JButton.class)
                .filter(button -> REPAIR.equals(ComponentFinder.accessibleName(button)));
    }
}
