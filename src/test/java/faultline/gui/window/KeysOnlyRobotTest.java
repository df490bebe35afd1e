package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.instrument.InstrumentDock;
import faultline.gui.panel.ControlPanel;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.paint.surface.Camera;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JComboBox;
import javax.swing.JList;
import javax.swing.JSlider;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/** Something in each area of the window, done with keys alone as {@code docs/keys.md} says. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class KeysOnlyRobotTest {

    private WindowDriver driver;

    @BeforeEach
    void open() {
        driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/office.xml"));
        driver.robot().waitFor("the canvas has the focus", () -> driver.canvas().isFocusOwner());
    }

    @AfterEach
    void close() {
        driver.close();
    }

    private void press(int... keys) {
        for (int key : keys) {
            driver.type(key);
        }
    }

    private void waitForFocus(String what, Component component) {
        driver.robot().waitFor(what + " has the focus", component::isFocusOwner);
    }

    private <T extends Component> T find(Class<T> type) {
        return ComponentFinder.findAll(driver.window(), type).findFirst().orElseThrow();
    }

    /** Presses Tab until a component has the focus. */
    private void tabTo(Component component) {
        driver.robot()
                .repeatUntil(
                        "Tab has reached " + ComponentFinder.accessibleName(component), component::isFocusOwner, () -> {
                            Component before = callOnEdt(KeysOnlyRobotTest::focusOwner);
                            driver.type(KeyEvent.VK_TAB);
                            driver.robot().waitFor("the focus moves on", () -> focusOwner() != before);
                        });
    }

    private static Component focusOwner() {
        return KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
    }

    private List<Obstacle> obstacles() {
        return driver.frame().snapshot().obstacles();
    }

    @Test
    void aCircleIsAddedFromTheMenuAndAWallIsDrawnPointByPoint() {
        int before = obstacles().size();
        driver.type(KeyEvent.VK_ALT, KeyEvent.VK_O);
        press(KeyEvent.VK_C);
        driver.robot().waitForPaint();
        press(KeyEvent.VK_INSERT);
        driver.waitForFrame(
                "the circle is there", frame -> frame.snapshot().obstacles().size() == before + 1);
        driver.type(KeyEvent.VK_ALT, KeyEvent.VK_O);
        press(KeyEvent.VK_W);
        for (int i = 0; i < 6; i++) {
            driver.type(KeyEvent.VK_SHIFT, KeyEvent.VK_UP);
        }
        press(KeyEvent.VK_INSERT);
        for (int i = 0; i < 5; i++) {
            driver.type(KeyEvent.VK_SHIFT, KeyEvent.VK_RIGHT);
        }
        press(KeyEvent.VK_INSERT, KeyEvent.VK_ENTER);
        driver.waitForFrame(
                "the wall is there", frame -> frame.snapshot().obstacles().size() == before + 2);
        ObstacleShape.WallShape wall =
                (ObstacleShape.WallShape) obstacles().get(before + 1).shape();
        assertEquals(0.5, wall.points().get(0).distanceTo(wall.points().get(1)), 1e-9);
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        driver.waitForFrame(
                "the wall is gone", frame -> frame.snapshot().obstacles().size() == before + 1);
    }

    @Test
    void aThemeAndATextSizeFromTheMenuLeaveTheFocusWhereItWas() {
        driver.type(KeyEvent.VK_ALT, KeyEvent.VK_V);
        press(KeyEvent.VK_D);
        driver.robot().waitFor("the theme is dark", () -> Theme.current() == Theme.DARK);
        waitForFocus("the canvas", driver.canvas());
        driver.robot().waitForPaint();
        driver.type(KeyEvent.VK_ALT, KeyEvent.VK_V);
        press(KeyEvent.VK_Z, KeyEvent.VK_A);
        driver.robot().waitFor("the text is large", () -> TextSize.current() == TextSize.LARGEST);
        for (int i = 0; i < 3; i++) {
            driver.robot().waitForPaint();
        }
        waitForFocus("the canvas", driver.canvas());
    }

    @Test
    void theViewAndASelectedObstacleAreMovedByArrows() {
        Camera before = callOnEdt(() -> driver.canvas().camera());
        press(KeyEvent.VK_RIGHT);
        driver.robot()
                .waitFor("the view has moved", () -> driver.canvas().camera().x() > before.x());
        double x = obstacles().get(0).pose().x();
        press(KeyEvent.VK_N);
        driver.type(KeyEvent.VK_SHIFT, KeyEvent.VK_RIGHT);
        driver.waitForFrame("an obstacle has moved", frame -> frame.snapshot().obstacles().stream()
                .anyMatch(now -> obstacleMoved(now, x)));
    }

    private static boolean obstacleMoved(Obstacle now, double before) {
        return Math.abs(now.pose().x() - before - 0.1) < 1e-9;
    }

    @Test
    void theTimeLineMovesTheRunBack() {
        for (int i = 0; i < 20; i++) {
            press(KeyEvent.VK_PERIOD);
        }
        driver.waitForFrame("20 ticks are made", frame -> frame.snapshot().tick() == 20);
        press(KeyEvent.VK_F6);
        JSlider slider = ComponentFinder.find(driver.window(), JSlider.class, "Time line");
        waitForFocus("the time line", slider);
        press(KeyEvent.VK_LEFT);
        driver.waitForFrame("a tick before", frame -> frame.snapshot().tick() < 20);
        press(KeyEvent.VK_HOME);
        driver.waitForFrame("the start", frame -> frame.snapshot().tick() == 0);
    }

    @Test
    void anInstrumentIsChosenAndADividerIsMoved() {
        InstrumentDock dock = find(InstrumentDock.class);
        press(KeyEvent.VK_F6, KeyEvent.VK_F6, KeyEvent.VK_F6);
        driver.robot().waitFor("the instruments have the focus", () -> isIn(dock));
        tabTo(ComponentFinder.findAll(dock, Component.class)
                .filter(part -> "Strip chart".equals(ComponentFinder.accessibleName(part)))
                .findFirst()
                .orElseThrow());
        JSplitPane split = dock.split();
        int place = callOnEdt(split::getDividerLocation);
        press(KeyEvent.VK_F8);
        driver.robot().waitFor("the divider has the focus", () -> split.isFocusOwner());
        press(KeyEvent.VK_LEFT);
        driver.robot().waitFor("the divider moves", () -> split.getDividerLocation() < place);
        tabTo(dock);
        press(KeyEvent.VK_RIGHT, KeyEvent.VK_RIGHT);
        driver.robot().waitFor("the events show", () -> dock.getSelectedIndex() == 2);
    }

    private static boolean isIn(Component area) {
        Component owner = focusOwner();
        return owner != null && SwingUtilities.isDescendingFrom(owner, area);
    }

    @Test
    void aGainAndThePlaceOfAnObstacleAreTyped() {
        JTabbedPane tabs = ComponentFinder.findAll(find(ControlPanel.class), JTabbedPane.class)
                .findFirst()
                .orElseThrow();
        driver.type(KeyEvent.VK_SHIFT, KeyEvent.VK_F6);
        driver.robot().waitFor("the panel has the focus", () -> isIn(find(ControlPanel.class)));
        tabTo(tabs);
        press(KeyEvent.VK_RIGHT);
        driver.robot().waitFor("the controller shows", () -> tabs.getSelectedIndex() == 1);
        JTextField gain = ComponentFinder.find(driver.window(), JTextField.class, "k_d, rad/m");
        tabTo(gain);
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        press(KeyEvent.VK_2, KeyEvent.VK_9, KeyEvent.VK_ENTER);
        JComboBox<?> gains = ComponentFinder.find(driver.window(), JComboBox.class, "Gains");
        driver.robot()
                .waitFor(
                        "the gains are fixed",
                        () -> gains.getSelectedIndex() == 2 && gain.getText().equals("29.0"));
        tabTo(tabs);
        press(KeyEvent.VK_RIGHT, KeyEvent.VK_RIGHT);
        driver.robot().waitFor("the obstacles show", () -> tabs.getSelectedIndex() == 3);
        JList<?> list = ComponentFinder.find(driver.window(), JList.class, "Obstacles");
        tabTo(list);
        driver.robot().waitFor("the list is filled", () -> list.getModel().getSize() > 0);
        press(KeyEvent.VK_HOME);
        JTextField x = ComponentFinder.find(driver.window(), JTextField.class, "x, m");
        driver.robot().waitFor("the first one is selected", x::isEnabled);
        tabTo(x);
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        press(KeyEvent.VK_3, KeyEvent.VK_PERIOD, KeyEvent.VK_5, KeyEvent.VK_ENTER);
        driver.waitForFrame(
                "it is there",
                frame -> frame.snapshot().obstacles().get(0).pose().x() == 3.5);
        assertFalse(callOnEdt(driver::isRunning));
    }

    @Test
    void theStartOfTheRobotIsTyped() {
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_I);
        JTextField x = ComponentFinder.find(driver.dialog("Scenario properties"), JTextField.class, "Start x, m");
        driver.robot().repeatUntil("Tab has reached the field", x::isFocusOwner, () -> driver.robot()
                .pressKeys(KeyEvent.VK_TAB));
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        for (int key : new int[] {KeyEvent.VK_2, KeyEvent.VK_PERIOD, KeyEvent.VK_5, KeyEvent.VK_ENTER}) {
            driver.robot().pressKeys(key);
        }
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.waitForFrame(
                "the robot is there", frame -> frame.snapshot().pose().x() == 2.5);
        assertTrue(callOnEdt(() -> driver.window().getTitle().contains("*")));
    }
}
