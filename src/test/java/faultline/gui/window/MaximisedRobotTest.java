package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.gui.EdtChecker;
import faultline.gui.settings.Preference;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.theme.Theme;
import java.awt.Frame;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/** A window that was closed maximised opens maximised, and is as large as before when it is restored. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class MaximisedRobotTest {

    private static final Path SCENARIO = Path.of("scenarios/yard.xml");

    private final Map<String, String> texts = new HashMap<>();
    private final WindowPreferences memory = new WindowPreferences(
            new WindowPreferences.PreferenceStore(key -> texts.getOrDefault(key, ""), texts::put));

    @Test
    void theMaximisedStateIsRememberedWithTheNormalSize() {
        Rectangle screen = callOnEdt(
                () -> GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds());
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, SCENARIO, memory)) {
            runOnEdt(() -> driver.window().setSize(1111, 666));
            waitForWidth(driver, 1111);
            runOnEdt(() -> driver.window().setExtendedState(Frame.MAXIMIZED_BOTH));
            waitUntilItFills(driver, screen);
            driver.choose("quit");
        }
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, SCENARIO, memory)) {
            waitUntilItFills(driver, screen);
            assertEquals(Frame.MAXIMIZED_BOTH, callOnEdt(driver.window()::getExtendedState));
            runOnEdt(() -> driver.window().setExtendedState(Frame.NORMAL));
            waitForWidth(driver, 1111);
            driver.choose("quit");
        }
        assertFalse(memory.get(Preference.MAXIMISED));
        assertEquals(666, memory.get(Preference.BOUNDS).orElseThrow().height);
    }

    /** Waits until a window is as wide as the screen but for borders. */
    private static void waitUntilItFills(WindowDriver driver, Rectangle screen) {
        driver.robot()
                .waitFor(
                        "the window fills the screen",
                        () -> driver.window().getWidth() > screen.width - 40
                                && driver.window().getExtendedState() == Frame.MAXIMIZED_BOTH);
    }

    private static void waitForWidth(WindowDriver driver, int width) {
        driver.robot().waitFor("the width is " + width, () -> driver.window().getWidth() == width);
    }
}
