package faultline.gui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.Threshold;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.world.Command;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JDialog;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** Changes of the controller as marks in the last lane of the time line, with the mouse and with keys alone. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class ControllerMarksRobotTest {

    private static final String DIALOG = "Controller change";

    @TempDir
    private Path folder;

    private Path file;
    private WindowDriver driver;
    private LanesDriver lanes;

    @BeforeEach
    void open() throws IOException {
        file = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("office.xml"));
        driver = WindowDriver.open(Theme.LIGHT, file);
        lanes = new LanesDriver(driver, 10);
    }

    @AfterEach
    void close() {
        driver.close();
    }

    private List<TimedCommand> saved() throws ScenarioException {
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        driver.waitForTitle("office.xml");
        return Scenario.load(file).setup().timeline();
    }

    private static double lostMargin(TimedCommand timed) {
        return ((WallFollowing) ((Command.ConfigureController) timed.command()).controller())
                .thresholds()
                .get(Threshold.LOST_MARGIN);
    }

    private void enter(String field, int... keys) {
        JDialog dialog = driver.dialog(DIALOG);
        JTextField text = ComponentFinder.find(dialog, JTextField.class, field);
        driver.click(text);
        driver.robot().waitFor("the field has the focus", text::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        for (int key : keys) {
            driver.robot().pressKeys(key);
        }
    }

    @Test
    void aChangeIsAddedDraggedAndEditedWithTheMouse() throws ScenarioException {
        lanes.doubleClick(50);
        enter("Wall lost, m", KeyEvent.VK_0, KeyEvent.VK_PERIOD, KeyEvent.VK_1);
        driver.clickButton(DIALOG, "OK");
        driver.waitForTitle("office.xml*");
        List<TimedCommand> added = saved();
        assertEquals(1, added.size());
        assertEquals(50, added.get(0).time(), 1.5);
        assertEquals(0.1, lostMargin(added.get(0)));
        lanes.drag(50, 90);
        driver.waitForTitle("office.xml*");
        List<TimedCommand> dragged = saved();
        assertEquals(90, dragged.get(0).time(), 2.5);
        assertEquals(added.get(0).command(), dragged.get(0).command());
        lanes.doubleClick(dragged.get(0).time());
        enter("Wall lost, m", KeyEvent.VK_0, KeyEvent.VK_PERIOD, KeyEvent.VK_2);
        driver.clickButton(DIALOG, "OK");
        driver.waitForTitle("office.xml*");
        assertEquals(0.2, lostMargin(saved().get(0)));
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        driver.waitForTitle("office.xml*");
        assertEquals(dragged, saved());
    }

    @Test
    void everythingCanBeDoneWithKeys() throws ScenarioException {
        driver.robot().waitFor("the canvas has the focus", () -> driver.canvas().isFocusOwner());
        driver.type(KeyEvent.VK_F6);
        driver.type(KeyEvent.VK_F6);
        driver.robot().waitFor("the lanes have the focus", lanes.view()::isFocusOwner);
        for (int lane = 1; lane < 11; lane++) {
            driver.type(KeyEvent.VK_DOWN);
        }
        driver.type(KeyEvent.VK_INSERT);
        driver.dialog(DIALOG);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        driver.robot().pressKeys(KeyEvent.VK_9);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.waitForTitle("office.xml*");
        List<TimedCommand> added = saved();
        assertEquals(9, added.get(0).time());
        assertEquals(
                Scenario.load(file).setup().controller(),
                ((Command.ConfigureController) added.get(0).command()).controller());
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_RIGHT);
        driver.waitForTitle("office.xml*");
        List<TimedCommand> moved = saved();
        assertTrue(moved.get(0).time() > 9);
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_D);
        driver.waitForTitle("office.xml*");
        assertEquals(2, saved().size());
        driver.type(KeyEvent.VK_DELETE);
        driver.waitForTitle("office.xml*");
        assertEquals(moved, saved());
        driver.type(KeyEvent.VK_LEFT);
        driver.type(KeyEvent.VK_ENTER);
        driver.dialog(DIALOG);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        driver.robot().pressKeys(KeyEvent.VK_7);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.waitForTitle("office.xml*");
        assertEquals(7, saved().get(0).time());
    }
}
