package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import faultline.paint.scene.Layer;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import javax.swing.JDialog;
import javax.swing.JTextField;
import javax.swing.MenuSelectionManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/** The character of a key that chooses an item of a menu. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class MenuKeysRobotTest {

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
    void itIsNotTypedIntoTheDialogThatOpens() {
        openMenu(KeyEvent.VK_S);
        postKey(KeyEvent.VK_J, 'j');
        JDialog dialog = driver.dialog("Jump to time");
        JTextField field = field(dialog, "Time");
        waitForFocus(field);
        assertEquals("0.00", callOnEdt(field::getText));
        driver.robot().pressKeys(KeyEvent.VK_3);
        driver.robot().waitFor("the digit is typed", () -> field.getText().equals("3"));
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the end of the dialog", () -> !dialog.isShowing());
    }

    @Test
    void itIsNotTypedIntoTheFieldThatHadTheFocus() {
        JTextField field = field(driver.window(), "Linear velocity");
        StringBuffer typed = new StringBuffer();
        runOnEdt(() -> field.addKeyListener(new KeyAdapter() {
            @Override
            public void keyTyped(KeyEvent event) {
                // A text field ignores the letter that opens the menu, because Alt is down.
                if (!event.isAltDown()) {
                    typed.append(event.getKeyChar());
                }
            }
        }));
        driver.click(field);
        waitForFocus(field);
        boolean grid = callOnEdt(() -> driver.canvas().isLayerOn(Layer.GRID));
        openMenu(KeyEvent.VK_V);
        postKey(KeyEvent.VK_G, 'g');
        driver.robot().waitFor("the grid is switched", () -> driver.canvas().isLayerOn(Layer.GRID) != grid);
        waitForFocus(field);
        driver.robot().pressKeys(KeyEvent.VK_7);
        driver.robot().waitFor("the digit is typed", () -> typed.indexOf("7") >= 0);
        assertEquals("7", typed.toString());
    }

    private static JTextField field(Window window, String name) {
        return ComponentFinder.find(window, JTextField.class, name);
    }

    private void waitForFocus(JTextField field) {
        driver.robot().waitFor("the field has the focus", field::isFocusOwner);
    }

    private void openMenu(int mnemonic) {
        driver.type(KeyEvent.VK_ALT, mnemonic);
        driver.robot()
                .waitFor(
                        "the menu is open",
                        () -> MenuSelectionManager.defaultManager().getSelectedPath().length > 0
                                && driver.window().getRootPane().isFocusOwner());
    }

    /** Presses and releases a key as a keyboard does whose character comes a millisecond after its press. */
    private void postKey(int key, char character) {
        runOnEdt(() -> {
            long now = System.currentTimeMillis();
            post(KeyEvent.KEY_PRESSED, now, key, character);
            post(KeyEvent.KEY_TYPED, now + 1, KeyEvent.VK_UNDEFINED, character);
            post(KeyEvent.KEY_RELEASED, now + 2, key, character);
        });
    }

    private void post(int id, long when, int key, char character) {
        EventQueue queue = Toolkit.getDefaultToolkit().getSystemEventQueue();
        queue.postEvent(new KeyEvent(driver.window(), id, when, 0, key, character));
    }
}
