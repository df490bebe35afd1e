package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.instrument.InstrumentDock;
import faultline.gui.theme.Theme;
import faultline.gui.timeline.TimelinePanel;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.stream.IntStream;
import javax.swing.JTable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/** The instruments and going back in time in a real window. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class InstrumentsRobotTest {

    private WindowDriver driver;

    @BeforeEach
    void open() {
        driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/office.xml"));
    }

    @AfterEach
    void close() {
        driver.close();
    }

    private InstrumentDock dock() {
        return ComponentFinder.findAll(driver.window(), InstrumentDock.class)
                .findFirst()
                .orElseThrow();
    }

    private int heightAboveDock() {
        TimelinePanel timeline = ComponentFinder.findAll(driver.window(), TimelinePanel.class)
                .findFirst()
                .orElseThrow();
        return driver.canvas().getHeight() + timeline.getHeight();
    }

    /** Runs fast until a time, then pauses. */
    private Frame runUntil(double seconds) {
        IntStream.range(0, 12).forEach(i -> driver.choose("faster"));
        driver.choose("run");
        driver.waitForFrame(
                "the run has come far enough", frame -> frame.snapshot().time() > seconds);
        driver.choose("run");
        driver.robot().waitFor("time is held", () -> !driver.isRunning());
        return driver.frame();
    }

    @Test
    void commaGoesBackByATickAndPeriodForward() {
        for (int i = 0; i < 3; i++) {
            driver.robot().pressKeys(KeyEvent.VK_PERIOD);
        }
        driver.waitForFrame("three ticks are made", frame -> frame.snapshot().tick() == 3);
        long hash = driver.frame().trajectoryHash();
        driver.robot().pressKeys(KeyEvent.VK_COMMA);
        driver.waitForFrame("one is taken back", frame -> frame.snapshot().tick() == 2);
        driver.robot().pressKeys(KeyEvent.VK_PERIOD);
        driver.waitForFrame("it is made again", frame -> frame.snapshot().tick() == 3);
        assertEquals(hash, driver.frame().trajectoryHash());
    }

    @Test
    void aDoubleClickOnAnEventGoesToItsMoment() {
        runUntil(12);
        runOnEdt(() -> dock().setSelectedIndex(2));
        JTable table = ComponentFinder.find(driver.window(), JTable.class, "Event log");
        driver.robot().waitFor("there are events", () -> table.getRowCount() > 3 && table.isShowing());
        runOnEdt(() -> {
            table.setRowSelectionInterval(0, 0);
            table.scrollRectToVisible(table.getCellRect(0, 0, true));
        });
        double time = Double.parseDouble(callOnEdt(() -> (String) table.getValueAt(0, 0)));
        Rectangle cell = callOnEdt(() -> table.getCellRect(0, 2, true));
        driver.robot().click(table, cell.getCenterX(), cell.getCenterY(), InputEvent.BUTTON1_DOWN_MASK);
        driver.robot().press(InputEvent.BUTTON1_DOWN_MASK);
        driver.robot().release(InputEvent.BUTTON1_DOWN_MASK);
        driver.waitForFrame(
                "the run is at that moment", frame -> Math.abs(frame.snapshot().time() - time) < 1e-9);
        assertTrue(callOnEdt(() -> !driver.isRunning()));
    }

    @Test
    void aKeyHidesTheInstrumentsAndShowsThemAtTheirOldHeight() {
        int height = callOnEdt(() -> dock().getHeight());
        int canvas = callOnEdt(() -> driver.canvas().getHeight());
        int rest = callOnEdt(this::heightAboveDock);
        driver.robot().pressKeys(KeyEvent.VK_I);
        driver.robot()
                .waitFor(
                        "the canvas and the time line have their room",
                        () -> driver.canvas().getHeight() > canvas && heightAboveDock() >= rest + height);
        driver.robot().pressKeys(KeyEvent.VK_I);
        driver.robot().waitFor("they are back", () -> dock().isShowing() && dock().getHeight() == height);
    }
}
