package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.EdtChecker;
import faultline.gui.document.RecoveryStore;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.world.Obstacle;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JDialog;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** The window after a crash, and when another program writes its file. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class RecoveryRobotTest {

    /** No process has this number: a window that stored its edits under it has crashed. */
    private static final String DEAD_PROCESS = Integer.MAX_VALUE - 7 + "-0";

    private final String home = System.getProperty("user.home");

    @TempDir
    private Path folder;

    private Path file;
    private Path recoveryFolder;
    private WindowDriver driver;

    @BeforeEach
    void open() throws IOException {
        System.setProperty("user.home", folder.toString());
        file = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("office.xml"));
        recoveryFolder =
                Files.createDirectories(folder.resolve(".faultline/recovery")).resolve(DEAD_PROCESS + ".xml");
        driver = WindowDriver.open(Theme.LIGHT, file);
    }

    @AfterEach
    void close() {
        // First, because a test that could not open the window has no driver.
        System.setProperty("user.home", home);
        driver.close();
    }

    private void crash() throws IOException {
        Files.writeString(recoveryFolder, seeded(4711));
        Files.writeString(folder.resolve(".faultline/recovery/" + DEAD_PROCESS + ".origin"), file.toString());
        runOnEdt(() -> driver.window().enableRecovery(RecoveryStore.forCurrentUser(), () -> {}));
    }

    private String seeded(long seed) throws IOException {
        return Files.readString(file)
                .replaceFirst("seed=\"\\d+\"", "")
                .replaceFirst("<scenario ", "<scenario seed=\"" + seed + "\" ");
    }

    /** Returns the names of all recovery files. */
    private String recoveryFileNames() throws IOException {
        try (Stream<Path> files = Files.list(recoveryFolder.getParent())) {
            return files.map(file -> file.getFileName().toString())
                    .filter(name -> name.endsWith(".xml"))
                    .collect(Collectors.joining());
        }
    }

    @Test
    void editsAfterACrashAreRecoveredAsUnsavedChanges() throws IOException, ScenarioException {
        crash();
        JDialog dialog = driver.dialog("Recover changes");
        assertTrue(WindowDriver.text(dialog).contains("office.xml"), WindowDriver.text(dialog));
        driver.clickButton("Recover changes", "Recover");
        driver.waitForTitle("office.xml*");
        driver.robot()
                .waitFor(
                        "it is kept under this window's number only",
                        () -> Files.notExists(recoveryFolder)
                                && recoveryFileNames()
                                        .matches(ProcessHandle.current().pid() + "-\\d+\\.xml"));
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        driver.waitForTitle("office.xml");
        assertEquals(4711, Scenario.load(file).setup().seed());
    }

    @Test
    void recoveredEditsAreDiscardedOnRequest() throws IOException {
        crash();
        driver.clickButton("Recover changes", "Discard");
        driver.robot().waitFor("it is gone", () -> Files.notExists(recoveryFolder));
        assertEquals("office.xml – Faultline", callOnEdt(driver.window()::getTitle));
    }

    @Test
    void editsAreOfferedAgainIfTheUserDecidesLater() throws IOException {
        crash();
        JDialog dialog = driver.dialog("Recover changes");
        driver.clickButton("Recover changes", "Decide later");
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isShowing());
        assertTrue(Files.exists(recoveryFolder));
        runOnEdt(() -> driver.window().enableRecovery(RecoveryStore.forCurrentUser(), () -> {}));
        driver.clickButton("Recover changes", "Recover");
        driver.waitForTitle("office.xml*");
    }

    @Test
    void aClosedRecoveryPromptIsShownAgain() throws IOException {
        crash();
        JDialog dialog = driver.dialog("Recover changes");
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isShowing());
        runOnEdt(() -> driver.window().enableRecovery(RecoveryStore.forCurrentUser(), () -> {}));
        driver.clickButton("Recover changes", "Discard");
        driver.robot().waitFor("it is gone", () -> Files.notExists(recoveryFolder));
    }

    /** Rewrites the file as another program does. */
    private void rewrite(long seed) throws IOException {
        Files.writeString(file, seeded(seed));
        Files.setLastModifiedTime(
                file, FileTime.fromMillis(Files.getLastModifiedTime(file).toMillis() + 5000));
    }

    @Test
    void anExternallyModifiedFileIsReloadedOnRequest() throws IOException {
        rewrite(4711);
        driver.clickButton("File changed", "Reload");
        driver.robot()
                .waitFor(
                        "the new file is open",
                        () -> driver.canvas().frame().orElseThrow().snapshot().tick() == 0);
        driver.waitForTitle("office.xml");
    }

    @Test
    void aDeclinedReloadIsUnsavedAndCanBeSaved() throws IOException, ScenarioException {
        Scenario before = Scenario.load(file);
        rewrite(4711);
        driver.clickButton("File changed", "Keep my version");
        driver.waitForTitle("office.xml*");
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        driver.waitForTitle("office.xml");
        assertEquals(before, Scenario.load(file));
    }

    @Test
    void unsavedChangesSurviveAnExternalChangeUnlessDiscarded() throws IOException {
        driver.drag(0, 0, 30);
        driver.waitForTitle("office.xml*");
        List<Obstacle> mine = driver.frame().snapshot().obstacles();
        rewrite(4711);
        JDialog dialog = driver.dialog("File changed");
        assertTrue(WindowDriver.text(dialog).contains("discards your unsaved changes"), WindowDriver.text(dialog));
        assertEquals(
                "Keep my version",
                callOnEdt(() -> dialog.getRootPane().getDefaultButton().getText()));
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isShowing());
        assertEquals("office.xml* – Faultline", callOnEdt(driver.window()::getTitle));
        assertEquals(mine, driver.frame().snapshot().obstacles());
    }
}
