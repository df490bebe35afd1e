package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.geometry.Vector2;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JButton;
import javax.swing.JSlider;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/**
 * Undoing the drag of an obstacle into the robot's path does not undo the collision; the window says how to undo it.
 */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class UndoneCollisionRobotTest {

    /** A tick after the drag, seconds before the collision. */
    private static final int TICK_BEFORE_COLLISION = 50;

    @TempDir
    private Path folder;

    @Test
    void theAdviceIsShownAndCorrect() throws IOException {
        Path scenario = Files.writeString(
                folder.resolve("beside.xml"),
                Files.readString(Path.of("scenarios/collision-on-purpose.xml"))
                        // The run must not pause at its end before the test pauses it.
                        .replace("duration=\"30\"", "duration=\"100000\"")
                        .replace("y=\"2.05\" radius=\"0.02\"", "y=\"3\" radius=\"0.1\""));
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, scenario)) {
            double metre = callOnEdt(() -> screenY(driver, 0) - screenY(driver, 1));
            // Undo of an edit at the start would change the start.
            driver.choose("step");
            driver.waitForFrame("the first tick", frame -> frame.snapshot().tick() == 1);
            driver.drag(0, 0, (int) metre);
            driver.runFast(frame -> frame.snapshot().collision().isPresent());
            driver.choose("run");
            driver.robot().waitFor("time is held", () -> !driver.isRunning());
            driver.choose("undo");
            driver.robot().waitFor("the window tells that the crash stays", () -> driver.statusNote()
                    .startsWith("The collision is not undone."));
            assertEquals(
                    "The collision is not undone. To undo it too, step back before it "
                            + "(,) and undo there, or restart (Ctrl+R)",
                    driver.statusNote());
            JSlider line = ComponentFinder.find(driver.window(), JSlider.class, "Time line");
            runOnEdt(() -> line.setValue(TICK_BEFORE_COLLISION));
            driver.waitForFrame(
                    "the run is before the crash", frame -> frame.snapshot().tick() == TICK_BEFORE_COLLISION);
            driver.choose("undo");
            driver.waitForFrame(
                    "the way is free",
                    frame -> frame.snapshot().obstacles().get(0).pose().y() == 3);
            driver.choose("run");
            driver.waitForFrame(
                    "the robot is past the place",
                    frame -> frame.snapshot().pose().x() > 5);
        }
    }

    private static double screenY(WindowDriver driver, double y) {
        return driver.canvas().camera().toScreen(new Vector2(0, y)).y();
    }

    /** There is nothing to step back to before the start of the run. */
    @Test
    void onlyARestartIsAdvisedAfterACollisionAtTheStart() {
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/collision-on-purpose.xml"))) {
            runOnEdt(() -> ComponentFinder.find(driver.window(), JTabbedPane.class, "Control panel")
                    .setSelectedIndex(3));
            driver.choose("selectAll");
            JTextField x = ComponentFinder.find(driver.window(), JTextField.class, "x, m");
            driver.robot().waitFor("the pole can be moved", x::isEnabled);
            driver.typeInto("x, m", KeyEvent.VK_1, KeyEvent.VK_ENTER);
            driver.waitForFrame(
                    "the pole touches the robot",
                    frame -> frame.snapshot().collision().isPresent());
            VerdictBanner banner = ComponentFinder.findAll(driver.canvas(), VerdictBanner.class)
                    .findFirst()
                    .orElseThrow();
            driver.robot().waitFor("the banner shows", banner::isShowing);
            JButton back = ComponentFinder.find(driver.window(), JButton.class, "Go to just before");
            assertFalse(callOnEdt(back::isShowing));
            driver.choose("undo");
            driver.robot().waitFor("the window says that the collision stays", () -> driver.statusNote()
                    .startsWith("The collision is not undone."));
            assertEquals("The collision is not undone. To undo it too, restart (Ctrl+R)", driver.statusNote());
            driver.choose("restart");
            driver.waitForFrame(
                    "the robot is free", frame -> frame.snapshot().collision().isEmpty());
        }
    }
}
