package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;

import faultline.gui.BackgroundThreads;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JProgressBar;
import javax.swing.JSlider;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** Seeking in a saved run of ten million seconds in a real window would take all day and can be cancelled. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class ProgressDialogRobotTest {

    private static final String DIALOG = "Please wait";

    @TempDir
    private Path folder;

    private WindowDriver driver;
    private JSlider line;

    @BeforeEach
    void openAndGoToTheEnd() throws IOException {
        String text = Files.readString(Path.of("scenarios/office.xml"))
                .replaceFirst("duration=\"180\"", "duration=\"10000000\" recorded=\"true\"");
        driver = WindowDriver.open(Theme.LIGHT, Files.writeString(folder.resolve("long.xml"), text));
        driver.type(KeyEvent.VK_PERIOD);
        driver.waitForFrame("one tick is made", frame -> frame.snapshot().tick() == 1);
        line = ComponentFinder.find(driver.window(), JSlider.class, "Time line");
        goToTheEnd();
    }

    private void goToTheEnd() {
        runOnEdt(line::requestFocusInWindow);
        driver.robot().waitFor("the line has the focus", line::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_END);
    }

    @AfterEach
    void close() {
        driver.close();
    }

    @Test
    void aLongSeekShowsProgressAndEscCancelsIt() {
        JDialog dialog = driver.dialog(DIALOG);
        assertEquals(
                "Going to another moment of long.xml",
                callOnEdt(() -> ComponentFinder.accessibleName(ComponentFinder.findAll(dialog, JProgressBar.class)
                        .findFirst()
                        .orElseThrow())));
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        assertRunIsUnchanged(dialog);
        assertEquals(1, driver.frame().snapshot().tick());
        driver.robot().waitFor("the line shows so", () -> line.getValue() == 1);
        driver.type(KeyEvent.VK_PERIOD);
        driver.waitForFrame("the run continues", frame -> frame.snapshot().tick() == 2);
    }

    @Test
    void theButtonCancelsALongSeek() {
        JDialog dialog = driver.dialog(DIALOG);
        driver.clickButton(DIALOG, "Cancel");
        assertRunIsUnchanged(dialog);
    }

    @Test
    void keysThatWereMeantForTheWindowCancelNothing() {
        JDialog dialog = driver.dialog(DIALOG);
        JProgressBar bar = callOnEdt(() ->
                ComponentFinder.findAll(dialog, JProgressBar.class).findFirst().orElseThrow());
        driver.robot().waitFor("the bar has the focus", bar::isFocusOwner);
        assertNull(callOnEdt(() -> dialog.getRootPane().getDefaultButton()), "Enter cancels");
        driver.robot().pressKeys(KeyEvent.VK_TAB);
        JButton cancel = callOnEdt(
                () -> ComponentFinder.findAll(dialog, JButton.class).findFirst().orElseThrow());
        driver.robot().waitFor("the button has the focus", cancel::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_SPACE);
        assertRunIsUnchanged(dialog);
    }

    @Test
    void theKeyThatQuitsClosesTheWindowAndCancelsTheSeek() {
        JDialog dialog = driver.dialog(DIALOG);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_Q);
        driver.robot().waitFor("the window is gone", () -> !driver.window().isDisplayable());
        assertFalse(callOnEdt(dialog::isDisplayable));
        BackgroundThreads.awaitEnd();
    }

    @Test
    void aSeekContinuesBehindTheQuestionWhetherToSave() {
        driver.clickButton(DIALOG, "Cancel");
        driver.drag(0, 20, 0);
        goToTheEnd();
        JDialog dialog = driver.dialog(DIALOG);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_Q);
        driver.clickButton("Unsaved changes", "Cancel");
        assertSame(dialog, driver.dialog(DIALOG));
        driver.clickButton(DIALOG, "Cancel");
    }

    private void assertRunIsUnchanged(JDialog dialog) {
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isShowing());
        assertEquals(1, driver.frame().snapshot().tick());
    }
}
