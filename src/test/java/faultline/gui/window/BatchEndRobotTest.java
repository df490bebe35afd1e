package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import faultline.campaign.run.Csv;
import faultline.gui.Await;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.SecondaryLoop;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.beans.PropertyChangeListener;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.UUID;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** What becomes of a batch when the user quits, closes its dialog, opens another scenario, or opens a run. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class BatchEndRobotTest {

    @TempDir
    private Path folder;

    /** The name of the scenario, by which its batch is recognised among those of other processes. */
    private final String name = "Yard " + UUID.randomUUID();

    private WindowDriver driver;

    @BeforeEach
    void open() throws Exception {
        Scenario yard = Scenario.load(Path.of("scenarios/yard.xml"));
        Path file = folder.resolve("short.xml");
        Scenario renamed = yard.withSetup(yard.setup().withDuration(3));
        renamed.save(file);
        Files.writeString(file, Files.readString(file).replace("name=\"Yard\"", "name=\"" + name + "\""));
        driver = WindowDriver.open(Theme.LIGHT, file);
    }

    @AfterEach
    void close() {
        driver.close();
    }

    /** Opens the dialog of batches and starts one. */
    private JDialog startBatch(String seeds, String duration) {
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_B);
        JDialog dialog = driver.dialog("Batch of " + name);
        enter(dialog, "Number of seeds", seeds);
        enter(dialog, "Duration", duration);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        return dialog;
    }

    private void enter(JDialog dialog, String field, String digits) {
        JTextField text = ComponentFinder.find(dialog, JTextField.class, field);
        driver.click(text);
        driver.robot().waitFor("the field has the focus", text::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        digits.chars().forEach(digit -> driver.robot().pressKeys(digit));
    }

    private void waitForRuns(JDialog dialog, int count) {
        driver.robot().waitFor(count + " runs are made", () -> ComponentFinder.findAll(dialog, JTable.class)
                .anyMatch(table -> "Runs".equals(ComponentFinder.accessibleName(table))
                        && table.getModel().getRowCount() >= count));
    }

    private static JTable runsOf(JDialog dialog) {
        return ComponentFinder.find(dialog, JTable.class, "Runs");
    }

    /** Waits for the question whether to save the results, and answers it with keys. */
    private void answerLoss(int... keys) {
        driver.robot().waitFor("the question about the results shows", () -> lossQuestion()
                .filter(JDialog::isFocused)
                .findAny()
                .isPresent());
        IntStream.of(keys).forEach(key -> driver.robot().pressKeys(key));
        driver.robot()
                .waitFor("the question is gone", () -> lossQuestion().findAny().isEmpty());
    }

    private static Stream<JDialog> lossQuestion() {
        return Stream.of(Window.getWindows())
                .filter(JDialog.class::isInstance)
                .map(JDialog.class::cast)
                .filter(Window::isShowing)
                .filter(dialog -> ComponentFinder.findAll(dialog, JOptionPane.class)
                        .anyMatch(pane -> String.valueOf(pane.getMessage()).contains("have not been saved")));
    }

    /** Returns the temporary folders of the batches of the scenario of this test. */
    private List<Path> batchFolders() throws IOException {
        try (Stream<Path> temporary = Files.list(Path.of(System.getProperty("java.io.tmpdir")))) {
            return temporary
                    .filter(entry -> entry.getFileName().toString().startsWith("faultline-batch-"))
                    .filter(this::isOwn)
                    .toList();
        }
    }

    /** The folder may be deleted at the same time. */
    private boolean isOwn(Path batch) {
        try (Stream<Path> files = Files.walk(batch, 1)) {
            return files.filter(file -> file.toString().endsWith(".xml")).anyMatch(file -> {
                try {
                    return Files.readString(file).contains(name);
                } catch (IOException e) {
                    return false;
                }
            });
        } catch (IOException | UncheckedIOException e) {
            return false;
        }
    }

    private static boolean isBatchThreadAlive() {
        return Thread.getAllStackTraces().keySet().stream()
                .anyMatch(thread -> thread.getName().equals("campaign")
                        || thread.getName().equals("faultline-background") && !thread.isDaemon());
    }

    private void assertNothingIsLeft() {
        // The thread that deletes the folder starts after that of the last run has ended.
        Await.until("the folder of the batch is gone", () -> batchFolders().isEmpty());
        Await.until("no thread of the batch is left", () -> !isBatchThreadAlive());
    }

    @Test
    void quittingDuringABatchAsksStopsItAndLeavesNothing() throws Exception {
        JDialog dialog = startBatch("9000", "3");
        waitForRuns(dialog, 3);
        assertEquals(1, batchFolders().size());
        driver.chooseLater("quit");
        answerLoss(KeyEvent.VK_ESCAPE);
        assertTrue(callOnEdt(driver.window()::isShowing), "quitting was cancelled");
        int before = callOnEdt(() -> runsOf(dialog).getModel().getRowCount());
        waitForRuns(dialog, before + 3);
        driver.chooseLater("quit");
        answerLoss(KeyEvent.VK_RIGHT, KeyEvent.VK_ENTER);
        driver.robot().waitFor("the window is gone", () -> !driver.window().isDisplayable());
        assertFalse(callOnEdt(dialog::isDisplayable));
        assertNothingIsLeft();
    }

    /** The title of the window changes when the file has been written. */
    @Test
    void quittingAsksAboutABatchThatIsStartedDuringTheSave() throws Exception {
        CountDownLatch saved = new CountDownLatch(1);
        AtomicReference<SecondaryLoop> pause = new AtomicReference<>();
        edit();
        runOnEdt(() -> driver.window().addPropertyChangeListener("title", event -> {
            pause.set(Toolkit.getDefaultToolkit().getSystemEventQueue().createSecondaryLoop());
            EventQueue.invokeLater(saved::countDown);
            pause.get().enter();
        }));
        driver.chooseLater("quit");
        driver.clickButton("Unsaved changes", "Save");
        saved.await();
        waitForRuns(startBatch("9000", "3"), 3);
        runOnEdt(() -> pause.get().exit());
        answerLoss(KeyEvent.VK_RIGHT, KeyEvent.VK_ENTER);
        driver.robot().waitFor("the window is gone", () -> !driver.window().isDisplayable());
        assertNothingIsLeft();
    }

    @Test
    void aDiscardedBatchIsNotAskedAboutAgainAfterTheSave() {
        edit();
        waitForRuns(startBatch("9000", "3"), 3);
        driver.chooseLater("quit");
        answerLoss(KeyEvent.VK_RIGHT, KeyEvent.VK_ENTER);
        driver.clickButton("Unsaved changes", "Save");
        driver.robot().waitFor("the window is gone", () -> !driver.window().isDisplayable());
        assertNothingIsLeft();
    }

    /** The event that says that the results are saved is paused before it asks what else would be lost. */
    @Test
    void aDialogThatIsClosedAgainDuringTheSaveAsksNothingAfterIt() throws Exception {
        CountDownLatch saved = new CountDownLatch(1);
        CountDownLatch handled = new CountDownLatch(1);
        SecondaryLoop pause = callOnEdt(
                () -> Toolkit.getDefaultToolkit().getSystemEventQueue().createSecondaryLoop());
        JDialog dialog = startBatch("1", "3");
        waitForRuns(dialog, 9);
        driver.robot().waitFor("the batch has ended", button(dialog, "Save results…")::isEnabled);
        PropertyChangeListener listener = event -> {
            if (String.valueOf(event.getNewValue()).contains("Saved as kept")) {
                EventQueue.invokeLater(saved::countDown);
                pause.enter();
                EventQueue.invokeLater(handled::countDown);
            }
        };
        runOnEdt(() -> ComponentFinder.findAll(dialog, JLabel.class)
                .forEach(label -> label.addPropertyChangeListener("text", listener)));
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        answerLoss(KeyEvent.VK_ENTER);
        driver.enterFile("Save results of the batch to a new folder", folder.resolve("kept"));
        saved.await();
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        answerLoss(KeyEvent.VK_RIGHT, KeyEvent.VK_ENTER);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isDisplayable());
        runOnEdt(pause::exit);
        handled.await();
        assertEquals(0, callOnEdt(() -> lossQuestion().count()));
        assertNothingIsLeft();
    }

    private void edit() {
        driver.type(KeyEvent.VK_1);
        driver.robot().waitFor("the edit", () -> driver.window().getTitle().contains("*"));
    }

    /** Enter gives the first answer, which keeps the results. */
    @Test
    void closingDuringABatchCanStopItAndSaveItsResults() throws Exception {
        JDialog dialog = startBatch("9000", "3");
        waitForRuns(dialog, 3);
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        answerLoss(KeyEvent.VK_ENTER);
        Path results = folder.resolve("kept");
        driver.enterFile("Save results of the batch to a new folder", results);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isDisplayable());
        int lines = Files.readAllLines(results.resolve("runs.csv")).size();
        assertTrue(lines > 3 && lines < 9000, lines + " lines");
        assertTrue(callOnEdt(driver.window()::isShowing));
        assertNothingIsLeft();
    }

    @Test
    void aStoppedBatchIsContinued() throws Exception {
        JDialog dialog = startBatch("9000", "3");
        JButton resume = button(dialog, "Continue");
        waitForRuns(dialog, 3);
        assertFalse(callOnEdt(resume::isEnabled));
        driver.click(button(dialog, "Stop"));
        driver.robot().waitFor("the batch can be continued", resume::isEnabled);
        int made = callOnEdt(() -> runsOf(dialog).getModel().getRowCount());
        driver.click(resume);
        waitForRuns(dialog, made + 3);
        assertFalse(callOnEdt(resume::isEnabled));
        driver.robot().waitFor("a key stops the batch again", button(dialog, "Stop")::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        answerLoss(KeyEvent.VK_RIGHT, KeyEvent.VK_ENTER);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isDisplayable());
        driver.robot().waitFor("the window has the focus", driver.window()::isFocused);
        assertNothingIsLeft();
    }

    @Test
    void aBatchThatCannotBeContinuedNowCanBeContinuedLater() throws Exception {
        JDialog dialog = startBatch("9000", "3");
        JButton resume = button(dialog, "Continue");
        waitForRuns(dialog, 3);
        driver.click(button(dialog, "Stop"));
        driver.robot().waitFor("the batch can be continued", resume::isEnabled);
        int made = callOnEdt(() -> runsOf(dialog).getModel().getRowCount());
        Path manifest = batchFolders().get(0).resolve("results/campaign.json");
        String before = Files.readString(manifest);
        Files.writeString(manifest, before.replace("plan_sha256\": \"", "plan_sha256\": \"0"));
        driver.click(resume);
        driver.robot().waitFor("the problem shows", () -> problems().anyMatch(problem -> problem.isFocused()));
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("the problem is gone", () -> problems().findAny().isEmpty());
        assertTrue(callOnEdt(resume::isEnabled));
        assertTrue(WindowDriver.text(dialog).contains("Stopped after " + made + " of"));
        Files.writeString(manifest, before);
        driver.click(resume);
        waitForRuns(dialog, made + 3);
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        answerLoss(KeyEvent.VK_RIGHT, KeyEvent.VK_ENTER);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isDisplayable());
    }

    private static Stream<JDialog> problems() {
        return Stream.of(Window.getWindows())
                .filter(JDialog.class::isInstance)
                .map(JDialog.class::cast)
                .filter(Window::isShowing)
                .filter(dialog -> ComponentFinder.findAll(dialog, JOptionPane.class)
                        .anyMatch(pane -> String.valueOf(pane.getMessage())
                                .replaceAll("\\s+", " ")
                                .contains("has changed. Start it again")));
    }

    @Test
    void closingTheDialogStopsARunThatWouldTakeHours() throws Exception {
        JDialog dialog = startBatch("1", "900000");
        driver.robot().waitFor("the runs are being made", BatchEndRobotTest::isBatchThreadAlive);
        Await.until("the plan is written", () -> {
            try {
                return batchFolders().size() == 1;
            } catch (IOException e) {
                return false;
            }
        });
        // There is no result yet, so no question is asked.
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isDisplayable());
        assertTrue(callOnEdt(driver.window()::isShowing));
        assertNothingIsLeft();
    }

    @Test
    void aBatchGoesOnWhenAnotherScenarioIsOpenedAndItsResultsAreSavedWhole() throws Exception {
        JDialog dialog = startBatch("20", "3");
        waitForRuns(dialog, 1);
        Path other = Path.of("scenarios/office.xml");
        EventQueue.invokeLater(() -> driver.window().open(other));
        driver.waitForTitle("office.xml");
        waitForRuns(dialog, 180);
        assertEquals("Batch of " + name, callOnEdt(dialog::getTitle));
        JButton save = button(dialog, "Save results…");
        driver.robot().waitFor("the results can be saved", save::isEnabled);
        driver.click(save);
        String title = "Save results of the batch to a new folder";
        JTextField suggested = ComponentFinder.findAll(driver.dialog(title), JTextField.class)
                .findFirst()
                .orElseThrow();
        assertTrue(callOnEdt(suggested::getText).endsWith("-batch"));
        Path results = folder.resolve("results");
        driver.enterFile(title, results);
        // The folder is there shortly before the dialog learns of it.
        driver.robot().waitFor("the results are saved", () -> ComponentFinder.findAll(dialog, JLabel.class)
                .anyMatch(label -> label.getText().matches("Runs: 180 in .*, failed: 0.*\\. Saved as results")));
        assertEquals(181, Files.readAllLines(results.resolve("runs.csv")).size());
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(
                    0, files.filter(file -> file.toString().endsWith(".tmp")).count());
        }
        callOnEdt(() -> {
            dialog.toFront();
            dialog.requestFocus();
            return true;
        });
        driver.robot().waitFor("the dialog has the focus", dialog::isFocused);
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the dialog is gone without a question", () -> !dialog.isDisplayable());
        assertNothingIsLeft();
    }

    private static JButton button(JDialog dialog, String text) {
        return ComponentFinder.findAll(dialog, JButton.class)
                .filter(button -> text.equals(button.getText()))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void aDoubleClickOpensTheRunOfTheRowAndOfTheCommandLine() throws Exception {
        JDialog dialog = startBatch("2", "3");
        waitForRuns(dialog, 18);
        driver.click(button(dialog, "Save plan as…"));
        Path plan = folder.resolve("plan.xml");
        driver.enterFile("Save plan of the batch", plan);
        Await.until("the plan is saved", () -> Files.exists(plan));
        callOnEdt(() -> {
            ComponentFinder.find(dialog, JTabbedPane.class, "Batch").setSelectedIndex(2);
            return true;
        });
        JTable runs = runsOf(dialog);
        driver.robot().waitFor("the runs show", runs::isShowing);
        int row = 7;
        String run = callOnEdt(() -> String.valueOf(runs.getValueAt(row, 0)));
        String hash = callOnEdt(
                () -> String.valueOf(runs.getValueAt(row, runs.getColumnModel().getColumnIndex("Trajectory hash"))));
        Rectangle cell = callOnEdt(() -> runs.getCellRect(row, 0, true));
        driver.robot().doubleClick(runs, cell.getCenterX(), cell.getCenterY());
        driver.waitForTitle("Run " + run);
        driver.robot().waitFor("the window has the focus", driver.window()::isFocused);
        driver.runFast(frame -> frame.snapshot().time() >= 3 - 1e-9);
        assertEquals(
                hash,
                String.format(Locale.ROOT, "%016x", driver.frame().trajectoryHash()),
                "the run that the window has made");
        assertEquals(hash, hashByCommandLine(plan, run));
    }

    /** Returns the hash of a run of a plan as the command {@code campaign} writes it. */
    private String hashByCommandLine(Path plan, String run) throws Exception {
        Path out = folder.resolve("campaign");
        Process campaign =
                JavaProcess.start("faultline.app.Main", List.of("campaign", plan.toString(), "--out", out.toString()));
        assertEquals(0, campaign.waitFor());
        List<List<String>> table = Files.readAllLines(out.resolve("runs.csv")).stream()
                .map(Csv::cells)
                .toList();
        int column = table.get(0).indexOf("trajectory_hash");
        return table.stream()
                .filter(cells -> cells.get(0).equals(run))
                .findFirst()
                .orElseThrow()
                .get(column);
    }
}
