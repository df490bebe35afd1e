package faultline.gui.window;

import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import java.nio.file.Path;
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

    @Test
    void aReferenceRunThatIsReadyAtRestIsShown() {
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, OFFICE)) {
            waitForRest(driver);
            driver.choose("keepGhost");
            driver.waitForReferenceRun();
            waitForRest(driver);
            driver.choose("removeGhost");
            driver.robot().waitFor("the reference run is gone", () -> !driver.isEnabled("removeGhost"));
        }
    }
}
