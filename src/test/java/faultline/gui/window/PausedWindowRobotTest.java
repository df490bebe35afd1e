package faultline.gui.window;

import static faultline.gui.GuiRobot.runOnEdt;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import java.nio.file.Path;
import javax.swing.JList;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/** A window without a run in progress polls nothing, but shows each change. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class PausedWindowRobotTest {

    private static final Path OFFICE = Path.of("scenarios/office.xml");

    private static void waitForRest(WindowDriver driver) {
        driver.robot().waitFor("the window rests", () -> driver.window().isResting());
    }

    @Test
    void aWindowWithoutAScenarioRests() {
        try (WindowDriver driver = WindowDriver.openEmpty()) {
            waitForRest(driver);
        }
    }

    @Test
    void aChangeAtRestIsShown() {
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, OFFICE)) {
            waitForRest(driver);
            driver.choose("step");
            driver.waitForFrame("the step shows", frame -> frame.snapshot().tick() == 1);
            waitForRest(driver);
            driver.choose("stepBack");
            driver.waitForFrame("the start shows", frame -> frame.snapshot().tick() == 0);
            waitForRest(driver);
            driver.choose("run");
            driver.waitForFrame(
                    "the run is under way", frame -> frame.snapshot().time() > 1.5);
            driver.choose("run");
            waitForRest(driver);
        }
    }

    /** Chooses as a screen reader does, which sends no events of the mouse or the keyboard. */
    @Test
    void aTabAndASelectionThatAreChosenAtRestAreShown() {
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, OFFICE)) {
            JTabbedPane tabs = ComponentFinder.find(driver.window(), JTabbedPane.class, "Control panel");
            JList<?> list = ComponentFinder.find(driver.window(), JList.class, "Obstacles");
            JTextField x = ComponentFinder.find(driver.window(), JTextField.class, "x, m");
            waitForRest(driver);
            runOnEdt(() -> tabs.setSelectedIndex(tabs.getTabCount() - 1));
            driver.robot()
                    .waitFor("the obstacles are listed", () -> list.getModel().getSize() > 0);
            waitForRest(driver);
            driver.choose("selectNext");
            driver.robot().waitFor("its place can be changed", x::isEnabled);
        }
    }

    @Test
    void aReferenceRunThatIsReadyAtRestIsShown() {
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, OFFICE)) {
            driver.choose("step");
            driver.robot().waitFor("the run can be kept", () -> driver.isEnabled("keepGhost"));
            waitForRest(driver);
            driver.choose("keepGhost");
            driver.waitForReferenceRun();
            waitForRest(driver);
            driver.choose("removeGhost");
            driver.robot().waitFor("the reference run is gone", () -> !driver.isEnabled("removeGhost"));
        }
    }
}
