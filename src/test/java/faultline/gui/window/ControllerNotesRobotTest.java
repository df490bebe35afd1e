package faultline.gui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.bar.StatusBar;
import faultline.gui.theme.Theme;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.IntStream;
import javax.swing.JLabel;
import javax.swing.JTable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** The notes in the status bar about a chosen controller are there only as long as they are true. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
class ControllerNotesRobotTest {

    private static final String READY =
            "#!/bin/sh\nread hello\necho '{\"type\":\"ready\",\"protocol\":1}'\nread line\n";

    @TempDir
    private Path folder;

    private Path script;
    private WindowDriver driver;

    @BeforeEach
    void open() throws IOException {
        script = Files.writeString(folder.resolve("follower.sh"), READY + "exit 7\n");
        assertTrue(script.toFile().setExecutable(true));
        driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/yard.xml"));
        driver.chooseLater("chooseController");
        driver.enterFile("Choose a controller", script);
    }

    @AfterEach
    void close() {
        driver.close();
    }

    private void waitForNote(String part) {
        driver.robot()
                .waitFor("the note \"" + part + "\"", () -> driver.statusNote().contains(part));
    }

    /** Restarts the run, which then has no note from the beginning. */
    private void restart() {
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_R);
        AtomicReference<String> note = new AtomicReference<>();
        driver.robot().waitFor("the new run shows", () -> {
            note.set(driver.statusNote());
            return showsState("Paused");
        });
        assertEquals("", note.get());
    }

    private boolean showsState(String state) {
        return ComponentFinder.findAll(driver.window(), StatusBar.class)
                .flatMap(bar -> ComponentFinder.findAll(bar, JLabel.class))
                .anyMatch(cell -> cell.getText().equals(state));
    }

    private void makeNewer() {
        assertTrue(script.toFile().setLastModified(script.toFile().lastModified() + 1000));
    }

    private List<String> events() {
        return ComponentFinder.findAll(driver.window(), JTable.class)
                .filter(table -> table.getColumnName(0).equals("Time, s"))
                .flatMap(table -> IntStream.range(0, table.getRowCount())
                        .mapToObj(row -> table.getValueAt(row, 1) + " " + table.getValueAt(row, 2)))
                .toList();
    }

    /** The lines of the start are there, too, although the run did not yet exist. */
    @Test
    void theEventLogListsWhatTheControllerPrintsEvenInAFlood() throws IOException {
        driver.robot().waitFor("the controller is there", () -> {
            driver.chooseOnEdt("step");
            return showsState("Failed");
        });
        Files.writeString(script, READY.replace("read hello", "read hello\necho loading >&2") + "exit 7\n");
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_R);
        driver.robot().waitFor("the line of the start", () -> events().contains("Output loading"));
        Files.writeString(script, READY + "seq 100000 >&2\necho done >&2\nexit 7\n");
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_R);
        driver.robot().waitFor("the new run", () -> !events().contains("Output loading"));
        driver.choose("step");
        driver.robot().waitFor("the last line", () -> events().contains("Output done"));
        assertEquals(
                300,
                events().stream().filter(event -> event.startsWith("Output")).count());
    }

    @Test
    void theNotesOfAFailedControllerGoWithItsRun() throws IOException {
        driver.robot().waitFor("the controller is there", () -> {
            driver.chooseOnEdt("step");
            return showsState("Failed");
        });
        waitForNote("ended with exit code 7");
        Files.writeString(script, READY + "exit 8\n");
        driver.choose("run");
        waitForNote("has failed at its start; restart it with Ctrl+R");
        makeNewer();
        waitForNote("follower.sh has changed");
        restart();
        driver.choose("step");
        waitForNote("ended with exit code 8");
        restart();
    }
}
