package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.Await;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** What becomes of a film of several thousand images when the user quits while it is being written. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class ExportEndRobotTest {

    private static final int TICKS = 18_000;

    @TempDir
    private Path folder;

    private WindowDriver driver;

    @BeforeEach
    void open() {
        driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/office.xml"));
    }

    @AfterEach
    void close() {
        driver.close();
    }

    @Test
    void quittingFromTheProgressOfAFilmAsksAndLeavesNothing() throws IOException {
        driver.runFast(frame -> frame.snapshot().tick() >= TICKS);
        driver.chooseLater("exportGif");
        driver.enterFile("Export animation", folder.resolve("film.gif"));
        JDialog progress = driver.dialog("Export");
        driver.robot().waitFor("the progress has the focus", progress::isFocused);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_Q);
        answer(KeyEvent.VK_ESCAPE);
        assertTrue(callOnEdt(driver.window()::isShowing), "quitting was cancelled");
        assertTrue(callOnEdt(progress::isShowing), "the film is still being written");
        driver.chooseLater("quit");
        answer(KeyEvent.VK_RIGHT, KeyEvent.VK_ENTER);
        driver.robot().waitFor("the window is gone", () -> !driver.window().isDisplayable());
        Await.until("no thread writes", () -> Thread.getAllStackTraces().keySet().stream()
                .noneMatch(thread -> thread.getName().equals("faultline-background") && !thread.isDaemon()));
        try (Stream<Path> left = Files.list(folder)) {
            assertEquals(List.of(), left.toList());
        }
    }

    @Test
    void theProgressOfAFilmIsInTheChosenLanguage() {
        driver.runFast(frame -> frame.snapshot().tick() >= TICKS);
        driver.chooseLater("exportGif");
        driver.enterFile("Export animation", folder.resolve("film.gif"));
        JDialog progress = driver.dialog("Export");
        driver.choose("languagePolish");
        try {
            driver.robot()
                    .waitFor(
                            "the title and the sentence are Polish",
                            () -> progress.getTitle().equals("Eksport")
                                    && ComponentFinder.findAll(progress, JLabel.class)
                                            .anyMatch(label -> label.getText().startsWith("Zapisywanie")));
        } finally {
            driver.choose("languageEnglish");
        }
        assertEquals("Export", callOnEdt(progress::getTitle));
        runOnEdt(() -> ComponentFinder.find(progress, JButton.class, "Cancel").doClick());
        driver.robot().waitFor("the film is given up", () -> !progress.isShowing());
    }

    /** Waits for the question whether to wait for the film, and answers it with keys. */
    private void answer(int... keys) {
        driver.robot().waitFor("the question shows", () -> questions().anyMatch(JDialog::isFocused));
        IntStream.of(keys).forEach(key -> driver.robot().pressKeys(key));
        driver.robot()
                .waitFor("the question is gone", () -> questions().findAny().isEmpty());
    }

    private static Stream<JDialog> questions() {
        return Stream.of(Window.getWindows())
                .filter(JDialog.class::isInstance)
                .map(JDialog.class::cast)
                .filter(Window::isShowing)
                .filter(dialog -> ComponentFinder.findAll(dialog, JOptionPane.class)
                        .anyMatch(pane -> String.valueOf(pane.getMessage()).contains("still writing")));
    }
}
