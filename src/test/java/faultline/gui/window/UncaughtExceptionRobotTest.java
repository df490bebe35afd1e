package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.GuiRobot;
import faultline.gui.dialog.UncaughtExceptionDialog;
import faultline.gui.theme.Theme;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.stream.Stream;
import javax.swing.JDialog;
import javax.swing.JLabel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real dialog, which needs a display")
class UncaughtExceptionRobotTest {

    private final Logger log = Logger.getLogger(UncaughtExceptionDialog.class.getName());
    private final GuiRobot robot = new GuiRobot();

    @BeforeEach
    void quiet() {
        GuiRobot.runOnEdt(Theme.LIGHT::install);
        log.setLevel(Level.OFF);
    }

    @AfterEach
    void loud() {
        log.setLevel(null);
    }

    @Test
    void faultsOnAnyThreadShowOneDialogWithASentenceAndNoStackTrace() {
        UncaughtExceptionDialog handler = new UncaughtExceptionDialog();
        for (int i = 0; i < 3; i++) {
            handler.uncaughtException(Thread.currentThread(), new IllegalStateException("the wheel came off"));
        }
        robot.waitFor(
                "the dialog has the focus",
                () -> dialogs().size() == 1 && dialogs().get(0).isFocused());
        String message = callOnEdt(() -> ComponentFinder.findAll(dialogs().get(0), JLabel.class)
                .map(JLabel::getText)
                .toList()
                .toString());
        assertTrue(message.contains("the wheel came off"), message);
        assertFalse(message.contains("at faultline"), message);
        robot.pressKeys(KeyEvent.VK_ESCAPE);
        robot.waitFor("the dialog is gone", () -> dialogs().isEmpty());
        assertEquals(0, callOnEdt(() -> dialogs().size()));
    }

    private static List<JDialog> dialogs() {
        return Stream.of(Window.getWindows())
                .filter(JDialog.class::isInstance)
                .map(JDialog.class::cast)
                .filter(JDialog::isShowing)
                .toList();
    }
}
