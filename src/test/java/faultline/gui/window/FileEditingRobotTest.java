package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.world.Obstacle;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JTable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Opening, editing and saving in a real window. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class FileEditingRobotTest {

    @TempDir
    private Path folder;

    private Path file;
    private WindowDriver driver;

    @BeforeEach
    void open() throws IOException {
        file = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("office.xml"));
        driver = WindowDriver.open(Theme.LIGHT, file);
    }

    @AfterEach
    void close() {
        driver.close();
    }

    @Test
    void anInvalidFileShowsEveryProblemWithItsLocationAndKeepsTheOldWorld() throws IOException {
        String text = Files.readString(file).replaceFirst("<robot ", "<robot lenght=\"1\" speed=\"-1\" ");
        Path broken = Files.writeString(folder.resolve("broken.xml"), text);
        List<Obstacle> before = driver.frame().snapshot().obstacles();
        runOnEdt(() -> driver.window().open(broken));
        JDialog dialog = dialog("Scenario not opened");
        JTable table = ComponentFinder.findAll(dialog, JTable.class).findFirst().orElseThrow();
        assertTrue(callOnEdt(table::getRowCount) >= 2);
        assertTrue(callOnEdt(() -> Integer.parseInt((String) table.getValueAt(0, 0))) > 1);
        assertTrue(callOnEdt(() -> table.getValueAt(0, 2).toString() + table.getValueAt(1, 2))
                .contains("lenght"));
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isShowing());
        assertEquals(before, driver.frame().snapshot().obstacles());
        assertEquals("office.xml – Faultline", callOnEdt(driver.window()::getTitle));
    }

    @Test
    void anObstacleDraggedDuringARunIsSavedAtItsNewPose() throws ScenarioException {
        driver.choose("run");
        driver.waitForFrame("time runs", frame -> frame.snapshot().tick() > 0);
        Pose before = driver.frame().snapshot().obstacles().get(0).pose();
        drag(0, 0, 40);
        driver.waitForFrame(
                "the obstacle has moved",
                frame -> !frame.snapshot().obstacles().get(0).pose().equals(before));
        driver.robot()
                .waitFor("the title is marked", () -> driver.window().getTitle().equals("office.xml* – Faultline"));
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        driver.robot()
                .waitFor("the mark is gone", () -> driver.window().getTitle().equals("office.xml – Faultline"));
        Scenario saved = Scenario.load(file);
        Pose after = saved.setup().world().obstacles().get(0).pose();
        assertNotEquals(before, after);
        driver.waitForFrame(
                "the obstacle is where it was saved",
                frame -> frame.snapshot().obstacles().get(0).pose().equals(after));
        runOnEdt(() -> driver.window().open(file));
        driver.waitForFrame("the saved file is open", frame -> frame.snapshot().tick() == 0);
        assertEquals(
                saved.setup().world().obstacles(), driver.frame().snapshot().obstacles());
    }

    @Test
    void closingWithUnsavedChangesAsksAndCancelKeepsTheWindow() {
        drag(0, 0, 30);
        driver.robot()
                .waitFor("the title is marked", () -> driver.window().getTitle().contains("*"));
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_Q);
        JDialog dialog = dialog("Unsaved changes");
        driver.click(ComponentFinder.findAll(dialog, JButton.class)
                .filter(button -> button.getText().equals("Cancel"))
                .findFirst()
                .orElseThrow());
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isShowing());
        assertTrue(callOnEdt(driver.window()::isShowing));
        // Without a window manager, only a click returns the focus.
        driver.robot().click(driver.canvas(), 5, 5, InputEvent.BUTTON1_DOWN_MASK);
        driver.robot().waitFor("the window has the focus again", driver.window()::isFocused);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_Q);
        JDialog again = dialog("Unsaved changes");
        driver.click(ComponentFinder.findAll(again, JButton.class)
                .filter(button -> button.getText().equals("Don't save"))
                .findFirst()
                .orElseThrow());
        driver.robot().waitFor("the window is closed", () -> !driver.window().isShowing());
    }

    @ParameterizedTest
    @CsvSource({"new, New scenario", "importPlan, Import floor plan"})
    void unsavedChangesAreAskedForBeforeTheFormOfANewScenario(String action, String title) {
        drag(0, 0, 30);
        driver.waitForTitle("office.xml*");
        driver.chooseLater(action);
        dialog("Unsaved changes");
        driver.robot().pressKeys(KeyEvent.VK_RIGHT);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        JDialog form = dialog(title);
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the dialog is gone", () -> !form.isShowing());
        assertEquals("office.xml* – Faultline", callOnEdt(driver.window()::getTitle));
    }

    @Test
    void escapeClosesAFileDialogWhereverInItTheFocusIs() {
        driver.chooseLater("open");
        JDialog dialog = driver.dialog("Open scenario");
        runOnEdt(() -> {
            dialog.getRootPane().setFocusable(true);
            dialog.getRootPane().requestFocusInWindow();
        });
        driver.robot().waitFor("nothing of the dialog has the focus", () -> dialog.getRootPane()
                .isFocusOwner());
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isShowing());
    }

    @Test
    void theShortcutsDialogListsEveryKeyAndFindsSome() {
        driver.robot().pressKeys(KeyEvent.VK_F1);
        JDialog dialog = dialog("Keyboard and mouse");
        JTable table = ComponentFinder.findAll(dialog, JTable.class).findFirst().orElseThrow();
        assertTrue(callOnEdt(table::getRowCount) > 25);
        assertEquals("File", callOnEdt(() -> table.getValueAt(0, 0)));
        assertEquals("Ctrl+N", callOnEdt(() -> table.getValueAt(0, 1)));
        driver.robot().pressKeys(KeyEvent.VK_G);
        driver.robot().pressKeys(KeyEvent.VK_H);
        driver.robot().pressKeys(KeyEvent.VK_O);
        driver.robot().waitFor("the rows about ghosts", () -> table.getRowCount() == 1);
        assertEquals("Ctrl+G", callOnEdt(() -> table.getValueAt(0, 1)));
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isShowing());
    }

    /** Drags an obstacle by its centre; pixels to the right and down. */
    private void drag(int index, int right, int down) {
        Pose pose = driver.frame().snapshot().obstacles().get(index).pose();
        Vector2 at = callOnEdt(() -> driver.canvas().camera().toScreen(pose.position()));
        driver.robot()
                .drag(driver.canvas(), at.x(), at.y(), at.x() + right, at.y() + down, InputEvent.BUTTON1_DOWN_MASK);
    }

    private JDialog dialog(String title) {
        driver.robot().waitFor("the dialog \"" + title + "\" shows and has the focus", () -> showing(title)
                .filter(Window::isFocused)
                .isPresent());
        return callOnEdt(() -> showing(title).orElseThrow());
    }

    private static Optional<JDialog> showing(String title) {
        return Stream.of(Window.getWindows())
                .filter(JDialog.class::isInstance)
                .map(JDialog.class::cast)
                .filter(dialog -> dialog.isShowing() && dialog.getTitle().equals(title))
                .findFirst();
    }
}
