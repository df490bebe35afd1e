package faultline.gui.window;

import static faultline.gui.GuiRobot.runOnEdt;

import faultline.engine.Frame;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import faultline.world.ObstacleShape;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JScrollBar;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** The import of a floor plan in the window. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class ImportRobotTest {

    private static final int SIDE = 60;
    private static final String TITLE = "Import hall.yaml";

    private WindowDriver driver;

    @TempDir
    private Path folder;

    @BeforeEach
    void open() {
        driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/office.xml"));
    }

    @AfterEach
    void close() {
        driver.close();
    }

    /** Writes a room with one speck. */
    private Path writeMap() throws IOException {
        StringBuilder text = new StringBuilder("P2\n" + SIDE + " " + SIDE + "\n255\n");
        for (int i = 0; i < SIDE * SIDE; i++) {
            int x = i % SIDE;
            int y = i / SIDE;
            boolean wall = x == 0 || y == 0 || x == SIDE - 1 || y == SIDE - 1;
            text.append(wall || x == 40 && y == 20 ? "0 " : "254 ");
        }
        Files.writeString(folder.resolve("hall.pgm"), text);
        return Files.writeString(folder.resolve("hall.yaml"), "image: hall.pgm\nresolution: 0.05\n");
    }

    private JDialog openMap() throws IOException {
        Path map = writeMap();
        driver.chooseLater("importPlan");
        driver.enterFile("Import floor plan", map);
        return driver.dialog(TITLE);
    }

    @Test
    void enterImportsThePlanWithTheNumberThatHasJustBeenTyped() throws IOException {
        JDialog dialog = openMap();
        JTextField smallest = ComponentFinder.find(dialog, JTextField.class, "Smallest wall, cells");
        runOnEdt(smallest::requestFocusInWindow);
        driver.robot()
                .waitFor(
                        "the text is selected",
                        () -> smallest.isFocusOwner() && "1".equals(smallest.getSelectedText()));
        driver.robot().pressKeys(KeyEvent.VK_2);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.waitForTitle("hall*");
        driver.waitForFrame("the walls without the speck", frame -> rings(frame) == 2);
    }

    @Test
    void aRefusedNumberHasTheFocusAfterItsMessage() throws IOException {
        JDialog dialog = openMap();
        JTextField smoothing = ComponentFinder.find(dialog, JTextField.class, "Smoothing, cells");
        runOnEdt(() -> {
            smoothing.requestFocusInWindow();
            smoothing.setText("99");
        });
        driver.robot().waitFor("the field has the focus", smoothing::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot()
                .waitFor(
                        "the message",
                        () -> !dialog.isFocused()
                                && Stream.of(dialog.getOwnedWindows()).anyMatch(Window::isFocused));
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("the refused field has the focus", smoothing::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the form is gone", () -> !smoothing.isShowing());
    }

    @Test
    void anImageThatCannotBeReadCanOnlyBeCancelled() throws IOException {
        Path broken = Files.writeString(folder.resolve("broken.png"), "hello");
        driver.chooseLater("importPlan");
        driver.enterFile("Import floor plan", broken);
        JDialog dialog = driver.dialog("Import broken.png");
        JButton accept = ComponentFinder.find(dialog, JButton.class, "OK");
        driver.robot().waitFor("the button is disabled", () -> !accept.isEnabled());
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the form is gone", () -> !accept.isShowing());
    }

    private static long rings(Frame frame) {
        return frame.snapshot().obstacles().stream()
                .map(obstacle -> obstacle.shape())
                .filter(ObstacleShape.PlanShape.class::isInstance)
                .mapToLong(plan -> ((ObstacleShape.PlanShape) plan).rings().size())
                .sum();
    }

    @Test
    void theDialogHasNoScrollBarAfterItWasNarrower() throws IOException {
        JDialog dialog = openMap();
        runOnEdt(() -> dialog.setSize(dialog.getWidth() - 40, dialog.getHeight()));
        driver.robot().waitFor("the scroll bar", () -> scrollBars(dialog) > 0);
        runOnEdt(() -> dialog.setSize(dialog.getWidth() + 60, dialog.getHeight() + 20));
        driver.robot().waitFor("no scroll bar", () -> scrollBars(dialog) == 0);
        driver.clickButton(TITLE, "Cancel");
    }

    private static long scrollBars(JDialog dialog) {
        return ComponentFinder.findAll(dialog, JScrollBar.class)
                .filter(JScrollBar::isShowing)
                .count();
    }
}
