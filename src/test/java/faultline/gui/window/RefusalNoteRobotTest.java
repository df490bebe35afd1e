package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.form.RefusalNote;
import faultline.gui.theme.Theme;
import java.awt.AWTException;
import java.awt.Color;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import javax.swing.JToolTip;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/** A field that refuses a text says why beside itself and to screen readers. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class RefusalNoteRobotTest {

    private WindowDriver driver;

    @BeforeEach
    void open() {
        driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/yard.xml"));
    }

    @AfterEach
    void close() {
        driver.close();
    }

    @Test
    void aSpeedThatTheMotorsCannotReachIsRefusedWithTheReason() {
        JTextField speed = ComponentFinder.find(driver.window(), JTextField.class, "Linear velocity");
        String before = callOnEdt(speed::getText);
        driver.typeInto("Linear velocity", KeyEvent.VK_5, KeyEvent.VK_0);
        waitForNote(speed, "Invalid value. Allowed: 0.01 to 0.6");
        driver.robot().pressKeys(KeyEvent.VK_TAB);
        waitForNote(speed, "50 is not allowed. Allowed: 0.01 to 0.6");
        assertEquals(before, callOnEdt(speed::getText));
        driver.typeInto("Linear velocity", KeyEvent.VK_0, KeyEvent.VK_PERIOD, KeyEvent.VK_2, KeyEvent.VK_TAB);
        driver.robot().waitFor("the note is gone", () -> notes().findAny().isEmpty());
        driver.waitForFrame("the speed", frame -> frame.snapshot().robot().speed() == 0.2);
    }

    @Test
    void aFieldThatIsHiddenWithItsTabNamesItselfInItsNote() {
        JTextField speed = ComponentFinder.find(driver.window(), JTextField.class, "Linear velocity");
        String before = callOnEdt(speed::getText);
        driver.typeInto("Linear velocity", KeyEvent.VK_5, KeyEvent.VK_0);
        JTabbedPane tabs = ComponentFinder.find(driver.window(), JTabbedPane.class, "Control panel");
        Rectangle controllerTab = callOnEdt(() -> tabs.getBoundsAt(1));
        driver.robot()
                .click(
                        tabs,
                        (int) controllerTab.getCenterX(),
                        (int) controllerTab.getCenterY(),
                        InputEvent.BUTTON1_DOWN_MASK);
        driver.robot().waitFor("the other tab", () -> tabs.getSelectedIndex() == 1);
        driver.robot().waitFor("the note", () -> notes().anyMatch(note ->
                note.getTipText().startsWith("Linear velocity: 50 is not allowed. Allowed: 0.01 to 0.6")));
        assertEquals(before, callOnEdt(speed::getText));
    }

    /** Swing shows the second sentence with the object that has shown the first. */
    @Test
    void aSentenceThatFollowsTheEndOfItsFieldsTabStays() {
        JTextField speed = ComponentFinder.find(driver.window(), JTextField.class, "Linear velocity");
        JTabbedPane tabs = ComponentFinder.find(driver.window(), JTabbedPane.class, "Control panel");
        RefusalNote note = callOnEdt(() -> new RefusalNote(speed));
        runOnEdt(() -> note.showBriefly("first"));
        runOnEdt(() -> {
            tabs.setSelectedIndex(1);
            tabs.validate();
            EventQueue.invokeLater(() -> note.showBriefly("second"));
        });
        runOnEdt(() -> assertFalse(speed.isShowing()));
        // The event that the field has gone has been handled by now, and what it has left for later is handled before
        // this.
        assertEquals(List.of("second"), callOnEdt(() -> notes().map(JToolTip::getTipText)
                .toList()));
    }

    @Test
    void aNoteLeavesTheNextFieldVisible() {
        JTabbedPane tabs = ComponentFinder.find(driver.window(), JTabbedPane.class, "Control panel");
        runOnEdt(() -> tabs.setSelectedIndex(1));
        driver.typeInto("Distance, m", KeyEvent.VK_9, KeyEvent.VK_9, KeyEvent.VK_TAB);
        Rectangle note = waitForNote("99 is not allowed. Allowed: 0.05 to 10", tip -> {});
        JComboBox<?> next = ComponentFinder.find(driver.window(), JComboBox.class, "Wall side");
        driver.robot().waitFor("the next field has the focus", next::isFocusOwner);
        assertFalse(note.intersects(callOnEdt(() -> boundsOnScreen(next))), note.toString());
    }

    @Test
    void aNoteAboutALongTextFitsInTheWindow() {
        JTextField speed = ComponentFinder.find(driver.window(), JTextField.class, "Linear velocity");
        driver.typeInto("Linear velocity", KeyEvent.VK_9);
        runOnEdt(() -> speed.setText("9".repeat(400)));
        driver.robot().pressKeys(KeyEvent.VK_TAB);
        String sentence = waitForNote(speed, "999");
        assertTrue(
                sentence.endsWith("... is not allowed. Allowed: 0.01 to 0.6. The value stays 0.30"),
                "the sentence is whole");
    }

    /** Waits for a note beside a field, and returns what screen readers get with it. */
    private String waitForNote(JTextField field, String start) {
        List<String> described = new ArrayList<>();
        Rectangle at = waitForNote(
                start, tip -> described.add(field.getAccessibleContext().getAccessibleDescription()));
        assertTrue(described.get(0).startsWith(start), described.get(0));
        Rectangle beside = callOnEdt(() -> boundsOnScreen(field));
        assertTrue(at.intersects(beside.x, beside.y, beside.width, 2.0 * beside.height), at + " beside " + beside);
        assertTrue(callOnEdt(() -> boundsOnScreen(driver.window())).contains(at), at.toString());
        return described.get(0);
    }

    /**
     * Waits for a note and returns its bounds on the screen. {@code seen} receives it at the moment it is found: a busy
     * machine may need the seconds for which it stays until the next look.
     */
    private Rectangle waitForNote(String start, Consumer<JToolTip> seen) {
        List<Rectangle> bounds = new ArrayList<>();
        driver.robot().waitFor("the note says " + start, () -> {
            notes().filter(tip -> tip.getTipText().startsWith(start)).findAny().ifPresent(tip -> {
                seen.accept(tip);
                bounds.add(boundsOnScreen(tip));
            });
            return !bounds.isEmpty();
        });
        return bounds.get(0);
    }

    private static Rectangle boundsOnScreen(Component part) {
        return new Rectangle(part.getLocationOnScreen(), part.getSize());
    }

    private Stream<JToolTip> notes() {
        return ComponentFinder.findAll(driver.window(), JToolTip.class).filter(Component::isShowing);
    }

    @Test
    void pointsThatAreNoneAreRefusedWithTheReason() {
        JTabbedPane tabs = ComponentFinder.find(driver.window(), JTabbedPane.class, "Control panel");
        runOnEdt(() -> tabs.setSelectedIndex(tabs.getTabCount() - 1));
        driver.choose("selectNext");
        JTextField waypoints = ComponentFinder.find(driver.window(), JTextField.class, "Waypoints, m");
        driver.robot().waitFor("an obstacle is selected", waypoints::isEnabled);
        runOnEdt(waypoints::requestFocusInWindow);
        driver.robot().waitFor("the field has the focus", waypoints::isFocusOwner);
        String before = callOnEdt(waypoints::getText);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        driver.robot().pressKeys(KeyEvent.VK_1);
        driver.robot().pressKeys(KeyEvent.VK_SEMICOLON);
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        waitForNote(waypoints, "Invalid points");
        assertEquals("1;", callOnEdt(waypoints::getText), "the text stays to be corrected");
        driver.robot().pressKeys(KeyEvent.VK_TAB);
        driver.robot().waitFor("the old points", () -> before.equals(waypoints.getText()));
    }

    @Test
    void escapeShowsTheOldPointsAgain() {
        JTabbedPane tabs = ComponentFinder.find(driver.window(), JTabbedPane.class, "Control panel");
        runOnEdt(() -> tabs.setSelectedIndex(tabs.getTabCount() - 1));
        driver.choose("selectNext");
        JTextField waypoints = ComponentFinder.find(driver.window(), JTextField.class, "Waypoints, m");
        driver.robot().waitFor("an obstacle is selected", waypoints::isEnabled);
        String before = callOnEdt(waypoints::getText);
        runOnEdt(() -> {
            waypoints.requestFocusInWindow();
            waypoints.setText("1;");
            waypoints.postActionEvent();
        });
        waitForNote(waypoints, "Invalid points");
        driver.robot().waitFor("the field has the focus", waypoints::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the old points", () -> before.equals(waypoints.getText()));
        assertTrue(callOnEdt(() -> notes().findAny().isEmpty()), "they are allowed");
    }

    @Test
    void theNoteAboutPointsEndsWhenTheyAreCorrected() {
        JTabbedPane tabs = ComponentFinder.find(driver.window(), JTabbedPane.class, "Control panel");
        runOnEdt(() -> tabs.setSelectedIndex(tabs.getTabCount() - 1));
        driver.choose("selectNext");
        JTextField waypoints = ComponentFinder.find(driver.window(), JTextField.class, "Waypoints, m");
        driver.robot().waitFor("an obstacle is selected", waypoints::isEnabled);
        runOnEdt(() -> {
            waypoints.requestFocusInWindow();
            waypoints.setText("1;");
            waypoints.postActionEvent();
        });
        waitForNote(waypoints, "Invalid points");
        runOnEdt(() -> {
            waypoints.setText("1,1 2,2");
            waypoints.postActionEvent();
        });
        assertEquals("1,1 2,2", callOnEdt(waypoints::getText));
        assertTrue(callOnEdt(() -> notes().findAny().isEmpty()), "it would cover other fields for seconds");
    }

    @Test
    void theBorderOfATextFieldShowsWhetherItHasTheFocus() throws AWTException {
        JTabbedPane tabs = ComponentFinder.find(driver.window(), JTabbedPane.class, "Control panel");
        runOnEdt(() -> tabs.setSelectedIndex(tabs.getTabCount() - 1));
        driver.choose("selectNext");
        JTextField waypoints = ComponentFinder.find(driver.window(), JTextField.class, "Waypoints, m");
        driver.robot().waitFor("an obstacle is selected", waypoints::isEnabled);
        driver.robot().waitForPaint();
        Robot screen = new Robot();
        Color without = callOnEdt(() -> leftEdge(screen, waypoints));
        runOnEdt(waypoints::requestFocusInWindow);
        driver.robot().waitFor("the border of the focus", () -> !leftEdge(screen, waypoints)
                .equals(without));
        driver.robot().pressKeys(KeyEvent.VK_TAB);
        driver.robot().waitFor("the border without it", () -> leftEdge(screen, waypoints)
                .equals(without));
    }

    private static Color leftEdge(Robot screen, JTextField field) {
        Rectangle at = boundsOnScreen(field);
        return screen.getPixelColor(at.x, at.y + at.height / 2);
    }
}
