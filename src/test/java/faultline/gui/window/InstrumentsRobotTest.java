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
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JTable;
import javax.swing.MenuSelectionManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** The instruments and going back in time in a real window. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class InstrumentsRobotTest {

    private static final int MANY = 40;

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
        driver.robot().doubleClick(table, cell.getCenterX(), cell.getCenterY());
        driver.waitForFrame(
                "the run is at that moment", frame -> Math.abs(frame.snapshot().time() - time) < 1e-9);
        assertTrue(callOnEdt(() -> !driver.isRunning()));
    }

    /** Enters a time, given its digits. */
    private void goTo(int... digits) {
        driver.chooseLater("goToTime");
        JDialog dialog = driver.dialog("Jump to time");
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        Arrays.stream(digits).forEach(digit -> driver.robot().pressKeys(digit));
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.robot().waitFor("the end of the dialog", () -> !dialog.isShowing());
    }

    @Test
    void theNewestEventIsInViewAfterAMoveBack() {
        runOnEdt(() -> dock().setSelectedIndex(2));
        JTable table = ComponentFinder.find(driver.window(), JTable.class, "Event log");
        goTo(KeyEvent.VK_1, KeyEvent.VK_7, KeyEvent.VK_0);
        driver.robot().waitFor("the log is long", () -> table.isShowing() && table.getRowCount() > 30);
        int later = callOnEdt(table::getRowCount);
        goTo(KeyEvent.VK_1, KeyEvent.VK_0, KeyEvent.VK_0);
        driver.robot().waitFor("later events are gone", () -> table.getRowCount() < later - 10);
        driver.robot().waitFor("the newest event is in view", () -> table.getVisibleRect()
                .contains(table.getCellRect(table.getRowCount() - 1, 0, false)));
    }

    /** The robot has so many sensors that the menu, with two lines for each, is higher than the screen. */
    @Test
    void severalLinesAreAddedToAChartFromAMenuThatFitsOnTheScreen(@TempDir Path folder) throws IOException {
        driver.close();
        Path file = folder.resolve("many.xml");
        String sensors = IntStream.range(0, MANY)
                .mapToObj(i -> "<sensor id=\"s" + i + "\" x=\"0\" y=\"0\" bearing=\"" + i + "\"/>")
                .collect(Collectors.joining("", "<robot x=\"2\" y=\"2\" heading=\"0\">", "</robot>"));
        Files.writeString(
                file,
                "<scenario xmlns=\"urn:faultline:scenario:1\" name=\"many\"><world width=\"4\" height=\"4\"/>" + sensors
                        + "</scenario>");
        driver = WindowDriver.open(Theme.LIGHT, file);
        JButton add = ComponentFinder.find(dock(), JButton.class, "Add signals");
        driver.robot().waitFor("the instruments show", add::isShowing);
        driver.robot().click(add, 5, 5, InputEvent.BUTTON1_DOWN_MASK);
        driver.robot().waitFor("the menu shows", () -> item(1).isShowing());
        Rectangle menu = callOnEdt(() -> new Rectangle(
                item(0).getParent().getLocationOnScreen(), item(0).getParent().getSize()));
        Rectangle screen = driver.window().getGraphicsConfiguration().getBounds();
        assertTrue(screen.contains(menu), menu + " on " + screen);
        for (int i = 0; i < 2; i++) {
            int index = i;
            AbstractButton line = callOnEdt(() -> item(index));
            driver.robot().click(line, 5, 5, InputEvent.BUTTON1_DOWN_MASK);
            driver.robot().waitFor("a line is added and the menu stays", () -> line.isSelected() && line.isShowing());
        }
        String table = callOnEdt(() -> dock().chart().content().orElseThrow().toCsv());
        assertTrue(table.contains("Sensor front, reported (m)") && table.contains("Sensor front, true (m)"), table);
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
    }

    /** Returns an item of the open menu, which is a button that does not show if none is open. */
    private static AbstractButton item(int index) {
        return Stream.of(MenuSelectionManager.defaultManager().getSelectedPath())
                .findFirst()
                .map(menu -> (AbstractButton) menu.getSubElements()[index].getComponent())
                .orElseGet(JButton::new);
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
