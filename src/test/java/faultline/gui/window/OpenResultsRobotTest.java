package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.PlanFiles;
import faultline.campaign.run.CampaignFolder;
import faultline.campaign.run.CampaignRunner;
import faultline.campaign.run.Shard;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JDialog;
import javax.swing.JTable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** Results that the command {@code campaign} has written, in a real window. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class OpenResultsRobotTest {

    private static final String CHOOSER = "Open results of a batch or campaign";
    private static final String TITLE = "Results: Three seeds";

    @TempDir
    private Path folder;

    private WindowDriver driver;
    private Path results;

    @BeforeEach
    void open() throws Exception {
        Scenario yard = Scenario.load(Path.of("scenarios/yard.xml"));
        yard.withSetup(yard.setup().withDuration(3)).save(folder.resolve("short.xml"));
        Path plan = Files.writeString(
                folder.resolve("plan.xml"),
                """
                <campaign xmlns="urn:faultline:campaign:1" name="Three seeds">
                  <worlds><scenario file="short.xml"/></worlds>
                  <seeds count="3"/>
                  <faults><healthy/><fault sensor="front left" kind="stuck" value="0.2..0.8" at="1"/></faults>
                </campaign>
                """);
        results = folder.resolve("results");
        new CampaignRunner(PlanFiles.read(plan), new CampaignFolder(results), Shard.ALL, 2)
                .run(false, (made, runs) -> {}, () -> false);
        driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/office.xml"));
    }

    @AfterEach
    void close() {
        driver.close();
    }

    private static JTable table(JDialog dialog, String name) {
        return ComponentFinder.find(dialog, JTable.class, name);
    }

    private JDialog openResults() {
        driver.chooseLater("openBatchResults");
        driver.enterFile(CHOOSER, results);
        return driver.dialog(TITLE);
    }

    /** Shows the runs of the first fault, the second row of the summary, and selects the first one. */
    private JTable selectRun(JDialog dialog) {
        driver.robot().waitFor("the summary has the focus", () -> table(dialog, "Summary")
                .isFocusOwner());
        driver.robot().pressKeys(KeyEvent.VK_DOWN);
        driver.robot().pressKeys(KeyEvent.VK_DOWN);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        JTable runs = table(dialog, "Runs");
        driver.robot().waitFor("its runs have the focus", () -> runs.isFocusOwner() && runs.getRowCount() == 3);
        return runs;
    }

    private String openRun(JDialog dialog) {
        JTable runs = selectRun(dialog);
        String run = callOnEdt(() -> String.valueOf(runs.getValueAt(0, 0)));
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.waitForTitle("Run " + run);
        return run;
    }

    @Test
    void aRunOfOpenedResultsOpensAndTheResultsComeBack() throws Exception {
        JDialog dialog = openResults();
        String text = WindowDriver.text(dialog);
        assertTrue(text.contains("Runs: 9, failed: 0") && text.contains("Controller: wall follower"), text);
        JTable runs = selectRun(dialog);
        String run = callOnEdt(() -> String.valueOf(runs.getValueAt(0, 0)));
        String hash = callOnEdt(
                () -> String.valueOf(runs.getValueAt(0, runs.getColumnModel().getColumnIndex("Trajectory hash"))));
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.waitForTitle("Run " + run);
        assertFalse(dialog.isShowing());
        Path saved = folder.resolve("run.xml");
        driver.chooseLater("saveAs");
        driver.enterFile("Save scenario", saved);
        driver.waitForTitle("run.xml");
        assertEquals(hash, Scenario.load(saved).run().trajectoryHash());
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_B);
        assertSame(dialog, driver.dialog(TITLE), "the results come back");
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isDisplayable());
    }

    @Test
    void hiddenResultsDoNotCoverAnotherScenarioUntilTheUserGoesBackToThem() {
        JDialog dialog = openResults();
        openRun(dialog);
        assertFalse(dialog.isShowing());
        runOnEdt(() -> driver.window().open(folder.resolve("short.xml")));
        driver.waitForTitle("short.xml");
        driver.robot().waitFor("the way back is named", () -> driver.statusNote()
                .equals("Ctrl+B goes back to the results of the batch"));
        assertFalse(dialog.isShowing());
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_B);
        assertSame(dialog, driver.dialog(TITLE));
        driver.robot().waitFor("the results have the focus", dialog::isFocused);
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isDisplayable());
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_B);
        driver.dialog("Batch of Yard");
    }

    /** The dialog that is hidden is that of the same folder, so it has gone and does not come back. */
    @Test
    void resultsThatAreOpenedAgainReplaceThoseThatAreHidden() {
        JDialog first = openResults();
        openRun(first);
        assertNotSame(first, openResults());
        assertFalse(first.isDisplayable());
        runOnEdt(() -> driver.window().open(folder.resolve("short.xml")));
        driver.waitForTitle("short.xml");
        driver.chooseLater("batch");
        driver.dialog("Batch of Yard");
        assertFalse(first.isDisplayable());
    }

    @Test
    void aRunThatIsOpenedAgainStillHasItsResults() {
        JDialog dialog = openResults();
        String run = openRun(dialog);
        driver.type(KeyEvent.VK_1);
        driver.waitForTitle("Run " + run + "*");
        driver.chooseLater("revert");
        driver.clickButton("Revert", "Revert");
        driver.waitForTitle("Run " + run);
        assertFalse(dialog.isShowing());
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_B);
        assertSame(dialog, driver.dialog(TITLE));
    }

    @Test
    void resultsStayIfTheQuestionAboutUnsavedChangesIsCancelled() {
        driver.type(KeyEvent.VK_1);
        driver.waitForTitle("office.xml*");
        JDialog dialog = openResults();
        selectRun(dialog);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        JDialog question = driver.dialog("Unsaved changes");
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the question is gone", () -> !question.isShowing());
        assertTrue(dialog.isShowing());
    }

    @Test
    void aFolderWithoutResultsGivesASentence() {
        driver.chooseLater("openBatchResults");
        driver.enterFile(CHOOSER, folder);
        JDialog problem = driver.dialog("Faultline");
        String text = WindowDriver.text(problem).replaceAll("\\s+", " ");
        assertTrue(text.contains(" cannot be opened: it is not a folder with the results of a batch"), text);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("the dialog is gone", () -> !problem.isShowing());
    }
}
