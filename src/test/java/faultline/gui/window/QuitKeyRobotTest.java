package faultline.gui.window;

import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import javax.swing.JDialog;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Ctrl+Q quits the program, also in dialogs that stay open beside the window. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class QuitKeyRobotTest {

    @ParameterizedTest
    @CsvSource({"guide, User guide", "batch, Batch of Office"})
    void theKeyQuitsInADialog(String action, String title) {
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/office.xml"))) {
            driver.chooseLater(action);
            JDialog dialog = driver.dialog(title);
            driver.robot().waitFor("the dialog has the focus", dialog::isFocused);
            driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_Q);
            driver.robot().waitFor("the window is gone", () -> !driver.window().isDisplayable());
        }
    }
}
