package faultline.gui.dialog;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.EdtChecker;
import java.awt.Dimension;
import java.awt.Toolkit;
import java.io.File;
import javax.swing.JDialog;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/** The dialog of a file chooser on a screen that is too small for it. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "makes a real dialog, which needs a display")
class FileChooserRobotTest {

    @Test
    void theDialogIsNotWiderOrHigherThanTheScreen() {
        Dimension screen = Toolkit.getDefaultToolkit().getScreenSize();
        JDialog dialog = callOnEdt(() -> {
            FileDialogs.EscapableFileChooser chooser = new FileDialogs.EscapableFileChooser(new File(""));
            chooser.setPreferredSize(new Dimension(screen.width + 200, screen.height + 200));
            return chooser.createDialog(null);
        });
        Dimension size = callOnEdt(dialog::getSize);
        runOnEdt(dialog::dispose);
        assertTrue(size.width <= screen.width && size.height <= screen.height, size + " on " + screen);
    }
}
