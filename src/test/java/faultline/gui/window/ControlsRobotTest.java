package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Degrees;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.panel.ControlPanel;
import faultline.gui.theme.Theme;
import faultline.paint.scene.Layer;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JDialog;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/** The control panel and the keys in a real window, by mouse and keyboard only. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class ControlsRobotTest {

    private WindowDriver driver;

    @BeforeEach
    void open() {
        // A locale with a decimal comma.
        Locale.setDefault(Locale.forLanguageTag("pl-PL"));
        driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/office.xml"));
    }

    @AfterEach
    void close() {
        driver.close();
    }

    @Test
    void theControlPanelIsAsWideAsItsRowsNeedWhateverTheFrameTakes() {
        ControlPanel panel = callOnEdt(() -> ComponentFinder.findAll(driver.window(), ControlPanel.class)
                .findFirst()
                .orElseThrow());
        driver.robot().waitFor("the panel has its width", () -> panel.getWidth() == panel.defaultWidth());
    }

    @Test
    void everySensorIsSwitchedOffByItsBoxAndOnAgainByItsKey() {
        List<String> ids = robot().sensors().stream().map(SensorSpec::id).toList();
        assertEquals(8, ids.size());
        for (String id : ids) {
            driver.click(ComponentFinder.find(driver.window(), JCheckBox.class, "Switch " + id + " on or off"));
            driver.waitForFrame(
                    id + " is off",
                    frame -> !frame.snapshot().robot().sensor(id).orElseThrow().on());
        }
        for (int i = 0; i < ids.size(); i++) {
            String id = ids.get(i);
            driver.robot().pressKeys(KeyEvent.VK_1 + i);
            driver.waitForFrame(
                    id + " is on",
                    frame -> frame.snapshot().robot().sensor(id).orElseThrow().on());
        }
    }

    @Test
    void rangeIsTypedWithACommaAndConeWithAPoint() {
        driver.typeInto(
                "Range of left, metres",
                KeyEvent.VK_1,
                KeyEvent.VK_COMMA,
                KeyEvent.VK_2,
                KeyEvent.VK_5,
                KeyEvent.VK_ENTER);
        driver.waitForFrame(
                "the range is 1.25 m",
                frame -> frame.snapshot().robot().sensor("left").orElseThrow().range() == 1.25);
        driver.typeInto(
                "Cone of left, degrees",
                KeyEvent.VK_3,
                KeyEvent.VK_5,
                KeyEvent.VK_PERIOD,
                KeyEvent.VK_5,
                KeyEvent.VK_ENTER);
        driver.waitForFrame(
                "the cone is 35.5 deg",
                frame -> frame.snapshot().robot().sensor("left").orElseThrow().cone() == Degrees.toRadians(35.5));
        assertEquals(1.25, robot().sensor("left").orElseThrow().range());
        assertEquals(0, driver.frame().snapshot().tick(), "the key did not advance the run");
    }

    @Test
    void aTabThatIsClickedHasTheFocusAndNotItsFirstField() {
        JTabbedPane tabs = callOnEdt(() -> ComponentFinder.find(driver.window(), JTabbedPane.class, "Control panel"));
        clickTab(tabs, 1);
        driver.click(ComponentFinder.find(driver.window(), JCheckBox.class, "Diagnosis"));
        clickTab(tabs, 0);
        driver.robot().waitFor("the focus of the tab", tabs::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_SPACE);
        driver.robot().waitFor("the run", driver::isRunning);
    }

    /** A field that was clicked just before has its focus, but not yet all events of it. */
    @Test
    void aTabHasTheFocusAlsoRightAfterAFieldOfTheLastTabHadIt() {
        JTabbedPane tabs = callOnEdt(() -> ComponentFinder.find(driver.window(), JTabbedPane.class, "Control panel"));
        clickTab(tabs, 1);
        JCheckBox diagnosis = ComponentFinder.find(driver.window(), JCheckBox.class, "Diagnosis");
        runOnEdt(() -> {
            diagnosis.requestFocusInWindow();
            SwingUtilities.invokeLater(() -> tabs.setSelectedIndex(0));
        });
        driver.robot().waitFor("tab 0", () -> tabs.getSelectedIndex() == 0);
        driver.robot().waitFor("the focus of the tab", tabs::isFocusOwner);
    }

    private void clickTab(JTabbedPane tabs, int index) {
        Rectangle title = callOnEdt(() -> tabs.getBoundsAt(index));
        driver.robot().click(tabs, title.getCenterX(), title.getCenterY(), InputEvent.BUTTON1_DOWN_MASK);
        driver.robot().waitFor("tab " + index, () -> tabs.getSelectedIndex() == index);
    }

    @Test
    void theRunGoesToATimeThatIsTyped() {
        driver.chooseLater("goToTime");
        JDialog dialog = driver.dialog("Jump to time");
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        for (int key : List.of(KeyEvent.VK_2, KeyEvent.VK_COMMA, KeyEvent.VK_5, KeyEvent.VK_ENTER)) {
            driver.robot().pressKeys(key);
        }
        driver.robot().waitFor("the end of the dialog", () -> !dialog.isShowing());
        driver.waitForFrame("2.5 s", frame -> frame.snapshot().tick() == 250);
        assertFalse(callOnEdt(driver::isRunning));
    }

    @Test
    void keysAreTypedWhileANumberIsEditedAndActOtherwise() {
        driver.typeInto("Linear velocity", KeyEvent.VK_7, KeyEvent.VK_SPACE, KeyEvent.VK_PERIOD, KeyEvent.VK_P);
        JTextField field = ComponentFinder.find(driver.window(), JTextField.class, "Linear velocity");
        driver.robot()
                .waitFor("the text without the space", () -> field.getText().equals("7.p"));
        assertFalse(callOnEdt(driver::isRunning));
        assertEquals(0, driver.frame().snapshot().tick());
        assertTrue(callOnEdt(() -> driver.canvas().isLayerOn(Layer.PATH)));
        focusCanvas();
        driver.robot().pressKeys(KeyEvent.VK_PERIOD);
        driver.waitForFrame("one tick is made", frame -> frame.snapshot().tick() == 1);
        driver.robot().pressKeys(KeyEvent.VK_SPACE);
        driver.robot().waitFor("time runs", driver::isRunning);
    }

    @Test
    void spaceRunsAfterEnterHasAppliedANumber() {
        driver.typeInto(
                "Linear velocity",
                KeyEvent.VK_0,
                KeyEvent.VK_PERIOD,
                KeyEvent.VK_2,
                KeyEvent.VK_ENTER,
                KeyEvent.VK_SPACE);
        driver.robot().waitFor("time runs", driver::isRunning);
        JTextField field = ComponentFinder.find(driver.window(), JTextField.class, "Linear velocity");
        assertEquals("0.20", callOnEdt(field::getText));
    }

    @Test
    void whatCannotBeTakenGoesBackToWhatIsTrue() {
        driver.typeInto("Cone of left, degrees", KeyEvent.VK_2, KeyEvent.VK_0, KeyEvent.VK_0, KeyEvent.VK_ENTER);
        focusCanvas();
        JTextField field = ComponentFinder.find(driver.window(), JTextField.class, "Cone of left, degrees");
        driver.robot().waitFor("the field shows 20 again", () -> field.getText().equals("20"));
    }

    @Test
    void aPlatformThatTheRobotHasNoRoomForGoesBack() {
        driver.typeInto("Platform length", KeyEvent.VK_9, KeyEvent.VK_ENTER);
        JTextField field = ComponentFinder.find(driver.window(), JTextField.class, "Platform length");
        driver.robot()
                .waitFor("the field shows 0.25 again", () -> field.getText().equals("0.25"));
        assertEquals(RobotSpec.DEFAULT.length(), robot().length());
    }

    @Test
    void theArrowsOfASpinnerSetTheVelocity() {
        double before = robot().speed();
        driver.click(ComponentFinder.find(driver.window(), JButton.class, "Increase Linear velocity"));
        driver.waitForFrame(
                "the velocity is higher", frame -> frame.snapshot().robot().speed() > before);
    }

    @Test
    void plusAndMinusZoomOnceForEachPress() {
        focusCanvas();
        double before = callOnEdt(this::scale);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_EQUALS);
        driver.robot().waitFor("the view is larger", () -> scale() > before);
        double larger = callOnEdt(this::scale);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_MINUS);
        driver.robot().waitFor("the view is as before", () -> Math.abs(scale() - before) < 1e-9);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_ADD);
        driver.robot().waitFor("the view is as large again", () -> Math.abs(scale() - larger) < 1e-9);
    }

    private double scale() {
        return driver.canvas().camera().scale();
    }

    @Test
    void runPauseStepAndRestartGoByKeys() {
        focusCanvas();
        driver.robot().pressKeys(KeyEvent.VK_SPACE);
        driver.waitForFrame("time has run", frame -> frame.snapshot().tick() > 20);
        driver.robot().pressKeys(KeyEvent.VK_SPACE);
        driver.robot().waitFor("time is held", () -> !driver.isRunning());
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_R);
        driver.waitForFrame("time is 0 again", frame -> frame.snapshot().tick() == 0);
        driver.robot().pressKeys(KeyEvent.VK_PERIOD);
        driver.waitForFrame("one tick is made", frame -> frame.snapshot().tick() == 1);
    }

    @Test
    void aFaultIsInjectedAndCleared() {
        driver.click(ComponentFinder.find(driver.window(), JButton.class, "Inject"));
        driver.waitForFrame(
                "the front sensor is broken",
                frame -> frame.snapshot().sensors().get(0).faults().size() == 1);
        driver.robot().waitFor("it is listed", () -> ComponentFinder.findAll(driver.window(), JButton.class)
                .anyMatch(button -> ComponentFinder.accessibleName(button).startsWith("Repair front")));
        driver.click(ComponentFinder.findAll(driver.window(), JButton.class)
                .filter(button -> ComponentFinder.accessibleName(button).startsWith("Repair front"))
                .findFirst()
                .orElseThrow());
        driver.waitForFrame(
                "it is repaired",
                frame -> frame.snapshot().sensors().get(0).faults().isEmpty());
    }

    @Test
    void theThemeIsSwitchedWhileTheRunGoesOn() {
        driver.choose("run");
        driver.waitForFrame("time runs", frame -> frame.snapshot().tick() > 0);
        driver.choose("dark");
        assertEquals(Theme.DARK, callOnEdt(Theme::current));
        long tick = driver.frame().snapshot().tick();
        driver.waitForFrame("time still runs", frame -> frame.snapshot().tick() > tick);
        assertEquals(
                Theme.DARK.colours().background().getRGB(),
                callOnEdt(() -> driver.window().getContentPane().getBackground().getRGB()));
    }

    private void focusCanvas() {
        driver.click(driver.canvas());
        callOnEdt(() -> driver.canvas().requestFocusInWindow());
        driver.robot().waitFor("the canvas has the focus", driver.canvas()::isFocusOwner);
    }

    private RobotSpec robot() {
        return driver.frame().snapshot().robot();
    }

    @Test
    void spacePressesTheButtonOfADialogInsteadOfRunning() {
        driver.chooseLater("chooseController");
        JDialog dialog = driver.dialog("Choose a controller");
        JButton cancel = ComponentFinder.findAll(dialog, JButton.class)
                .filter(button -> "Cancel".equals(button.getText()))
                .findFirst()
                .orElseThrow();
        runOnEdt(cancel::requestFocusInWindow);
        driver.robot().waitFor("the button has the focus", cancel::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_SPACE);
        driver.robot().waitFor("the dialog is gone", () -> !dialog.isShowing());
        assertFalse(callOnEdt(driver::isRunning));
    }

    /** The next field, which would have it otherwise, may be out of sight, and would receive the next keys. */
    @Test
    void theCanvasGetsTheFocusOfAFieldThatIsDisabled() {
        JComboBox<?> choice = ComponentFinder.findAll(driver.window(), JComboBox.class)
                .filter(box -> box.isShowing() && box.isEnabled())
                .findFirst()
                .orElseThrow();
        runOnEdt(choice::requestFocusInWindow);
        driver.robot().waitFor("the field has the focus", choice::isFocusOwner);
        runOnEdt(() -> choice.setEnabled(false));
        driver.robot().waitFor("the canvas has the focus", driver.canvas()::isFocusOwner);
    }
}
