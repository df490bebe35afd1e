package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import java.awt.Rectangle;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JButton;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** The banner at the end of a run, by mouse. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class VerdictRobotTest {

    @TempDir
    private Path folder;

    private static VerdictBanner banner(WindowDriver driver) {
        return ComponentFinder.findAll(driver.canvas(), VerdictBanner.class)
                .findFirst()
                .orElseThrow();
    }

    @Test
    void theBannerOfACollisionLeadsBackToBeforeIt() {
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/collision-on-purpose.xml"))) {
            Rectangle canvas = callOnEdt(() -> driver.canvas().getBounds());
            driver.runFast(frame -> frame.snapshot().collision().isPresent());
            driver.robot().waitFor("the banner shows", () -> banner(driver).isShowing());
            assertEquals(canvas, callOnEdt(() -> driver.canvas().getBounds()), "nothing moves");
            driver.click(callOnEdt(() -> ComponentFinder.find(driver.window(), JButton.class, "Go to just before")));
            driver.waitForFrame("two seconds before", frame -> frame.snapshot().tick() == 757);
            driver.robot().waitFor("the banner is gone", () -> !banner(driver).isShowing());
            driver.robot().waitFor("keys reach the canvas", driver.canvas()::isFocusOwner);
        }
    }

    @Test
    void theRunPausesAtItsEndAndShowsItsVerdict() throws IOException {
        Path scenario = Files.writeString(
                folder.resolve("short.xml"),
                Files.readString(Path.of("scenarios/collision-on-purpose.xml"))
                        .replaceFirst("duration=\"[^\"]*\"", "duration=\"1.5\""));
        try (WindowDriver driver = WindowDriver.open(Theme.DARK, scenario)) {
            driver.choose("run");
            driver.robot().waitFor("the banner shows", () -> banner(driver).isShowing());
            assertEquals(150, driver.frame().snapshot().tick());
            assertTrue(callOnEdt(() -> banner(driver).getAccessibleContext().getAccessibleName())
                    .contains("1 of 1 expectations failed"));
            driver.choose("run");
            driver.waitForFrame("the user may go on", frame -> frame.snapshot().tick() > 160);
            driver.robot().waitFor("the banner is gone", () -> !banner(driver).isShowing());
        }
    }
}
