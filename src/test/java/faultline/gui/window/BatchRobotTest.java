package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JTable;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** A batch in a real window, with keys alone. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class BatchRobotTest {

    private static final String TITLE = "Batch of Yard";

    @TempDir
    private Path folder;

    private WindowDriver driver;

    @BeforeEach
    void open() throws Exception {
        Scenario yard = Scenario.load(Path.of("scenarios/yard.xml"));
        Path file = folder.resolve("short.xml");
        yard.withSetup(yard.setup().withDuration(3)).save(file);
        driver = WindowDriver.open(Theme.LIGHT, file);
    }

    @AfterEach
    void close() {
        driver.close();
    }

    private static JTable table(JDialog dialog, String name) {
        return ComponentFinder.find(dialog, JTable.class, name);
    }

    @Test
    void keysMakeABatchAndOpenOneOfItsRuns() throws Exception {
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_B);
        JDialog dialog = driver.dialog(TITLE);
        driver.robot().waitFor("the number of seeds has the focus", () -> "Number of seeds"
                .equals(ComponentFinder.accessibleName(dialog.getFocusOwner())));
        driver.robot().pressKeys(KeyEvent.VK_2);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("all runs are made", () -> dialogHasRuns(dialog, 18));
        driver.robot().waitFor("the summary has the focus", () -> table(dialog, "Summary")
                .isFocusOwner());
        // The second row is the first fault; Enter shows its runs and selects the first one.
        driver.robot().pressKeys(KeyEvent.VK_DOWN);
        driver.robot().pressKeys(KeyEvent.VK_DOWN);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        JTable runs = table(dialog, "Runs");
        driver.robot().waitFor("its runs have the focus", () -> runs.isFocusOwner() && runs.getRowCount() == 2);
        String run = callOnEdt(() -> String.valueOf(runs.getValueAt(0, 0)));
        String hash = callOnEdt(() -> String.valueOf(runs.getValueAt(0, column(runs, "Trajectory hash"))));
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.waitForTitle("Run " + run);
        driver.robot().waitFor("the way back is named", () -> driver.statusNote()
                .equals("A run of the batch. Ctrl+B goes back to the results"));
        assertFalse(dialog.isShowing());
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_B);
        assertSame(dialog, driver.dialog(TITLE), "the results are still there");
        driver.robot().waitFor("the runs have the focus again", runs::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("the window has the focus", driver.window()::isFocused);
        Path saved = folder.resolve("run.xml");
        driver.chooseLater("saveAs");
        driver.enterFile("Save scenario", saved);
        driver.waitForTitle("run.xml");
        assertEquals(hash, Scenario.load(saved).run().trajectoryHash());
    }

    @Test
    void aRunInTheWindowDoesNotReplaceTheScenarioOfTheBatch() {
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_B);
        JDialog dialog = driver.dialog(TITLE);
        driver.robot().waitFor("the number of seeds has the focus", () -> "Number of seeds"
                .equals(ComponentFinder.accessibleName(dialog.getFocusOwner())));
        driver.robot().pressKeys(KeyEvent.VK_1);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("all runs are made", () -> dialogHasRuns(dialog, 9));
        driver.robot().waitFor("the summary has the focus", () -> table(dialog, "Summary")
                .isFocusOwner());
        driver.robot().pressKeys(KeyEvent.VK_DOWN);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("the runs have the focus", table(dialog, "Runs")::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.waitForTitle("Run 0");
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_B);
        driver.robot().waitFor("the results show again", dialog::isFocused);
        driver.click(button(dialog, "Save results…"));
        JDialog chooser = driver.dialog("Save results of the batch to a new folder");
        String suggested = callOnEdt(() -> ComponentFinder.findAll(chooser, JTextField.class)
                .findFirst()
                .orElseThrow()
                .getText());
        assertEquals(folder.resolve("short-batch"), Path.of(suggested));
        driver.robot().waitFor("the chooser has the focus", chooser::isFocused);
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the results have the focus", dialog::isFocused);
        driver.click(button(dialog, "Open scenario"));
        driver.waitForTitle("short.xml");
        assertTrue(dialog.isShowing());
    }

    private static JButton button(JDialog dialog, String text) {
        return ComponentFinder.findAll(dialog, JButton.class)
                .filter(button -> text.equals(button.getText()))
                .findFirst()
                .orElseThrow();
    }

    private static boolean dialogHasRuns(JDialog dialog, int count) {
        return ComponentFinder.findAll(dialog, JTable.class)
                .anyMatch(table -> "Runs".equals(ComponentFinder.accessibleName(table))
                        && table.getModel().getRowCount() == count);
    }

    private static int column(JTable table, String title) {
        return table.getColumnModel().getColumnIndex(title);
    }
}
