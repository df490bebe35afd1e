package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.instrument.PositionedSplitPane;
import faultline.gui.settings.Preference;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import javax.swing.JScrollBar;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** The lanes of a real window zoomed with the wheel and with keys, and the run moved to their marks. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class LanesZoomRobotTest {

    private static final String TIMELINE = "<timeline><fault at=\"2\" sensor=\"front\" kind=\"stuck\" value=\"0.4\""
            + " until=\"3\"/><switch at=\"4\" sensor=\"rear\" on=\"false\"/></timeline>";

    @TempDir
    private Path folder;

    private final Map<String, String> stored = new HashMap<>();
    private final WindowPreferences preferences = new WindowPreferences(
            new WindowPreferences.PreferenceStore(key -> stored.getOrDefault(key, ""), stored::put));
    private Path file;
    private WindowDriver driver;
    private LanesDriver lanes;

    @BeforeEach
    void open() throws IOException {
        file = folder.resolve("office.xml");
        Files.writeString(
                file, Files.readString(Path.of("scenarios/office.xml")).replace("<expect", TIMELINE + "<expect"));
        openWindow();
    }

    private void openWindow() {
        driver = WindowDriver.open(Theme.LIGHT, file, preferences);
        lanes = new LanesDriver(driver, 0);
        driver.robot().waitFor("a mark ahead", () -> driver.isEnabled("nextEvent"));
    }

    @AfterEach
    void close() {
        driver.close();
    }

    /** The scroll bar is visible while not all of the run is. */
    private JScrollBar timeScroll() {
        return ComponentFinder.find(driver.window(), JScrollBar.class, "Visible part of the run");
    }

    private double shownShare() {
        return callOnEdt(() -> timeScroll().isVisible() ? timeScroll().getVisibleAmount() / 1e6 : 1.0);
    }

    /** Turns the wheel over the first lane while Ctrl is held; negative notches are away from the user. */
    private void zoomByWheel(int notches) {
        Rectangle place = callOnEdt(() -> lanes.view().getVisibleRect());
        driver.robot().moveTo(lanes.view(), place.getCenterX(), place.y + 20.0);
        driver.robot().whileHolding(KeyEvent.VK_CONTROL, () -> driver.robot().rotateWheel(notches));
    }

    @Test
    void ctrlWithTheWheelZoomsTheLanesAndTheWheelAloneDoesNot() {
        assertEquals(1, shownShare());
        zoomByWheel(-4);
        driver.robot().waitFor("less is visible", () -> timeScroll().isVisible());
        assertEquals(Math.pow(1.25, -4), shownShare(), 0.001);
        driver.robot().rotateWheel(2);
        driver.robot().waitForPaint();
        assertEquals(Math.pow(1.25, -4), shownShare(), 0.001);
        zoomByWheel(4);
        driver.robot().waitFor("all is visible", () -> !timeScroll().isVisible());
    }

    @Test
    void keysZoomTheLanesAndAreDisabledWhereTheyDoNothing() {
        assertFalse(callOnEdt(() -> driver.isEnabled("lanesZoomOut")));
        driver.type(KeyEvent.VK_SHIFT, KeyEvent.VK_EQUALS);
        driver.robot().waitFor("less is visible", () -> driver.isEnabled("lanesZoomOut"));
        assertEquals(0.8, shownShare(), 0.001);
        driver.type(KeyEvent.VK_SHIFT, KeyEvent.VK_EQUALS);
        driver.type(KeyEvent.VK_MINUS);
        driver.robot().waitFor("one step", () -> Math.abs(timeScroll().getVisibleAmount() / 1e6 - 0.8) < 0.001);
        driver.type(KeyEvent.VK_W);
        driver.robot().waitFor("all is visible", () -> !driver.isEnabled("lanesWhole"));
        assertEquals(1, shownShare());
        driver.choose("timeline");
        driver.robot().waitFor("there is nothing to zoom", () -> !driver.isEnabled("lanesZoomIn"));
    }

    @Test
    void keysMoveTheRunToTheMarksAndTheZoomStays() {
        driver.choose("lanesZoomIn");
        driver.type(KeyEvent.VK_SHIFT, KeyEvent.VK_PERIOD);
        waitForTick(200);
        assertTrue(callOnEdt(driver::statusNote).startsWith("2.00 s: front: stuck"), callOnEdt(driver::statusNote));
        goTo("nextEvent", 300);
        goTo("nextEvent", 400);
        driver.robot().waitFor("the mark before", () -> driver.isEnabled("previousEvent"));
        driver.type(KeyEvent.VK_SHIFT, KeyEvent.VK_COMMA);
        waitForTick(300);
        goTo("previousEvent", 200);
        driver.robot().waitFor("nothing is marked before", () -> !driver.isEnabled("previousEvent"));
        assertTrue(callOnEdt(driver::statusNote).startsWith("2.00 s: front: stuck"), callOnEdt(driver::statusNote));
        driver.choose("restart");
        waitForTick(0);
        assertFalse(callOnEdt(driver::statusNote).startsWith("2.00 s"), "the note about another time has ended");
        assertEquals(0.8, shownShare(), 0.001);
    }

    private void goTo(String action, long tick) {
        driver.robot().waitFor("the action is enabled", () -> driver.isEnabled(action));
        driver.choose(action);
        waitForTick(tick);
    }

    private void waitForTick(long tick) {
        driver.waitForFrame("tick " + tick, frame -> frame.snapshot().tick() == tick);
        driver.robot().waitForPaint();
    }

    @Test
    void aFaultDrawnInZoomedLanesIsWhereItWasDrawnAndAnotherScenarioShowsAllOfTheRun() throws ScenarioException {
        for (int i = 0; i < 12; i++) {
            driver.choose("lanesZoomIn");
        }
        double length = 180 * Math.pow(1.25, -12);
        Rectangle place = callOnEdt(() -> timeScroll().getBounds());
        double y = callOnEdt(() -> lanes.view().getVisibleRect().y) + 14 + 17 + 6.0;
        double left = callOnEdt(() ->
                (double) timeScroll().getLocationOnScreen().x - lanes.view().getLocationOnScreen().x);
        driver.robot()
                .drag(
                        lanes.view(),
                        left + 0.2 * place.width,
                        y,
                        left + 0.6 * place.width,
                        y,
                        InputEvent.BUTTON1_DOWN_MASK);
        driver.clickButton("Fault", "OK");
        driver.waitForTitle("office.xml*");
        driver.type(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        driver.waitForTitle("office.xml");
        double drawn = Scenario.load(file).setup().timeline().stream()
                .mapToDouble(command -> command.time())
                .filter(time -> time > 4)
                .findFirst()
                .orElseGet(() -> Double.NaN);
        double tolerance = 3 * length / place.width + 0.05;
        assertTrue(
                Math.abs(drawn - 0.6 * length) < tolerance || Math.abs(drawn - 0.2 * length) < tolerance,
                drawn + " of " + length);
        assertEquals(length / 180, shownShare(), 0.001, "an edit keeps the zoom");
        runOnEdt(() -> driver.window().open(Path.of("scenarios/mirror.xml")));
        driver.waitForTitle("mirror.xml");
        driver.robot().waitFor("all is visible", () -> !timeScroll().isVisible());
    }

    @Test
    void theLanesShowWholeRowsAndKeepTheHeightThatTheUserHasGivenThem() {
        assertWholeRows();
        PositionedSplitPane stage = callOnEdt(() -> ComponentFinder.findAll(driver.window(), PositionedSplitPane.class)
                .filter(pane -> pane.getTopComponent() == driver.canvas())
                .findFirst()
                .orElseThrow());
        int before = callOnEdt(() -> lanes.view().getVisibleRect().height);
        runOnEdt(() -> stage.setDividerLocation(stage.getDividerLocation() - 60));
        driver.robot().waitFor("more lanes", () -> lanes.view().getVisibleRect().height > before + 20);
        assertWholeRows();
        int height = callOnEdt(() -> lanes.view().getVisibleRect().height);
        runOnEdt(() -> driver.window().dispatchEvent(new WindowEvent(driver.window(), WindowEvent.WINDOW_CLOSING)));
        driver.robot().waitFor("the window is closed", () -> !driver.window().isDisplayable());
        assertTrue(preferences.get(Preference.LANES_HEIGHT).isPresent());
        openWindow();
        driver.robot().waitFor("the same lanes", () -> lanes.view().getVisibleRect().height == height);
    }

    /** Each of the eleven lanes has one row. */
    private void assertWholeRows() {
        runOnEdt(() -> {
            Rectangle visible = lanes.view().getVisibleRect();
            int row = (lanes.view().getHeight() - 14) / 11;
            assertTrue(row >= 13, "rows of " + row);
            assertEquals(0, (visible.height - 14) % row, visible + " of rows of " + row);
            assertEquals(0, visible.y % row);
        });
    }
}
