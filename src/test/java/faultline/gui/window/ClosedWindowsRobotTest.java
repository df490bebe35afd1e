package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.lang.ref.WeakReference;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javax.swing.JDialog;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * Windows and dialogs that are closed keep nothing of the system's. A window can be reclaimed with its run: nothing
 * that outlives it refers to it.
 */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class ClosedWindowsRobotTest {

    private static final int WINDOWS = 4;
    private static final Map<String, String> DIALOGS = Map.of(
            "examples", "Examples",
            "preferences", "Preferences",
            "shortcuts", "Keyboard and mouse",
            "saveAs", "Save scenario",
            "chooseController", "Choose a controller");

    @Test
    void closedWindowsAreReclaimed() {
        List<WeakReference<MainWindow>> windows = new ArrayList<>();
        for (int i = 0; i < WINDOWS; i++) {
            windows.add(useAndClose());
        }
        Await.until("all but the one that Swing painted last are reclaimed", () -> {
            System.gc();
            return windows.stream().filter(window -> window.get() != null).count() <= 1;
        });
    }

    @Test
    void dialogsThatAreClosedByTheirTitleBarsAreDisposedOf() {
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/office.xml"))) {
            Map<String, String> dialogs = new HashMap<>(DIALOGS);
            dialogs.put("guide", "User guide");
            dialogs.forEach((action, title) -> {
                driver.chooseLater(action);
                JDialog dialog = driver.dialog(title);
                runOnEdt(() -> dialog.dispatchEvent(new WindowEvent(dialog, WindowEvent.WINDOW_CLOSING)));
                driver.robot().waitFor(title + " is gone", () -> !dialog.isShowing());
                assertEquals(List.of(), callOnEdt(() -> displayableDialogs(driver.window())));
            });
        }
    }

    private static List<String> displayableDialogs(Window owner) {
        return Stream.of(owner.getOwnedWindows())
                .filter(window -> window instanceof JDialog && window.isDisplayable())
                .map(window -> ((JDialog) window).getTitle())
                .toList();
    }

    private static WeakReference<MainWindow> useAndClose() {
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/office.xml"))) {
            driver.visitTabs(title -> {});
            DIALOGS.forEach((action, title) -> {
                driver.chooseLater(action);
                JDialog dialog = driver.dialog(title);
                driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
                driver.robot().waitFor("the dialog is gone", () -> !dialog.isShowing());
            });
            driver.choose("run");
            driver.waitForFrame("the run begins", frame -> frame.snapshot().tick() > 10);
            return new WeakReference<>(driver.window());
        }
    }
}
