package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.session.ReferenceRun;
import faultline.external.ControllerChoice;
import faultline.geometry.Pose;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.instrument.InstrumentDock;
import faultline.gui.theme.FlatSliderUI;
import faultline.gui.theme.Theme;
import faultline.paint.surface.Palette;
import faultline.scenario.Scenario;
import faultline.world.Command;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.stream.IntStream;
import javax.swing.JComboBox;
import javax.swing.JDialog;
import javax.swing.JSlider;
import javax.swing.JTable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/** A reference run beside the current one in a real window. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class ComparisonRobotTest {

    private static final Path OFFICE = Path.of("scenarios/office.xml");

    /** From this tick on, the two runs execute different commands. */
    private static final int CHANGE_TICK = 12;

    private WindowDriver driver;

    @BeforeEach
    void open() {
        driver = WindowDriver.open(Theme.LIGHT, OFFICE);
    }

    @AfterEach
    void close() {
        driver.close();
    }

    private void step(int ticks) {
        long from = driver.frame().snapshot().tick();
        IntStream.range(0, ticks).forEach(i -> driver.robot().pressKeys(KeyEvent.VK_PERIOD));
        driver.waitForFrame(ticks + " ticks are made", frame -> frame.snapshot().tick() == from + ticks);
    }

    private Object mark() {
        JSlider line = ComponentFinder.find(driver.window(), JSlider.class, "Time line");
        return line.getClientProperty(FlatSliderUI.MARK_PROPERTY);
    }

    @Test
    void aSensorSwitchedOffMakesTheRunDifferAndTheEventLogLeadsThere() throws Exception {
        step(30);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_G);
        driver.waitForReferenceRun();
        driver.choose("restart");
        driver.waitForFrame(
                "the run is at its start again", frame -> frame.snapshot().tick() == 0);
        step(CHANGE_TICK);
        assertEquals(null, callOnEdt(this::mark));
        driver.robot().pressKeys(KeyEvent.VK_3);
        step(10);
        int expected = (int) firstDifference();
        driver.robot().waitFor("the divergence is marked", () -> Integer.valueOf(expected)
                .equals(mark()));
        goThereByTheEventLog();
        driver.waitForFrame("the run is there", frame -> frame.snapshot().tick() == expected);
        assertEquals(expected, callOnEdt(this::mark));
    }

    private ReferenceRun ghost() {
        return callOnEdt(() -> driver.canvas().renderRequest(Palette.LIGHT).orElseThrow().references().stream()
                .findFirst()
                .orElseThrow()
                .run());
    }

    @Test
    void aScenarioOpensWithAControllerAndTheGhostOfAnother() {
        Pose start = driver.frame().snapshot().pose();
        runOnEdt(() -> driver.window()
                .open(
                        OFFICE,
                        () -> Scenario.load(OFFICE),
                        ControllerChoice.of("none"),
                        ControllerChoice.of("wall-follower")));
        driver.waitForReferenceRun();
        step(40);
        assertEquals(start, driver.frame().snapshot().pose());
        assertNotEquals(start, ghost().pose(40));
    }

    @Test
    void theGhostMayHaveAnotherControllerThanTheRun() {
        Pose start = driver.frame().snapshot().pose();
        driver.chooseLater("compareController");
        JDialog dialog = driver.dialog("Controller of the ghost");
        runOnEdt(() -> ComponentFinder.findAll(dialog, JComboBox.class)
                .findFirst()
                .orElseThrow()
                .setSelectedItem("none"));
        driver.robot().pressKeys(KeyEvent.VK_ENTER);
        driver.waitForReferenceRun();
        assertEquals(start, ghost().pose(1000));
    }

    /** Returns the first difference of two runs without the window. */
    private static long firstDifference() throws Exception {
        Scenario office = Scenario.load(OFFICE);
        try (Simulation one = new Simulation(office.setup(), ControllerMode.DIRECT);
                Simulation two = new Simulation(office.setup(), ControllerMode.DIRECT)) {
            while (one.trajectoryHash() == two.trajectoryHash()) {
                if (one.ticks() == CHANGE_TICK) {
                    two.execute(new Command.SwitchSensor("left", false));
                }
                one.tick();
                two.tick();
            }
            assertNotEquals(0, one.ticks());
            return one.ticks();
        }
    }

    private void goThereByTheEventLog() {
        runOnEdt(() -> ComponentFinder.findAll(driver.window(), InstrumentDock.class)
                .findFirst()
                .orElseThrow()
                .setSelectedIndex(2));
        JTable table = ComponentFinder.find(driver.window(), JTable.class, "Event log");
        driver.robot().waitFor("the log shows it", () -> table.isShowing() && row(table) >= 0);
        Rectangle cell = callOnEdt(() -> {
            table.scrollRectToVisible(table.getCellRect(row(table), 0, true));
            return table.getCellRect(row(table), 2, true);
        });
        driver.robot().doubleClick(table, cell.getX() + 20, cell.getCenterY());
    }

    private static int row(JTable table) {
        return IntStream.range(0, table.getRowCount())
                .filter(row -> "Ghost".equals(table.getValueAt(row, 1)))
                .findFirst()
                .orElse(-1);
    }
}
