package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.DurationStatistics;
import faultline.gui.EdtChecker;
import faultline.gui.EventThreadMeter;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.swing.JTabbedPane;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/**
 * How long the event dispatch thread is busy at a stretch while somebody tries everything, in a hall of 500 shapes and
 * with the run at full speed. It ends after a minute, or after as many gestures as the system property
 * {@code faultline.gestures} says, which a quiet machine makes in half a minute, but not before thirty. What is held to
 * the bound is the thread's own processor time, because other programs on the machine do not lengthen it; the time by
 * the clock is printed beside it. Nothing is warmed up: the first use of a dialog counts.
 */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class ResponsivenessRobotTest {

    /** Milliseconds. */
    private static final double MAX_BUSY_MILLIS = 50;

    private static final long SEED = 11;
    private static final int MIN_GESTURES = 31;
    private static final int MAX_GESTURES = Integer.getInteger("faultline.gestures", 110);
    private static final long MINUTE_NANOS = TimeUnit.SECONDS.toNanos(60);

    @TempDir
    private Path folder;

    @Test
    void theWindowStaysResponsiveDuringRandomInput() {
        assertEquals(List.of(), longBusyPeriods());
    }

    @Test
    void theFirstDisplayOfATabIsShort() throws IOException, ScenarioException {
        try (WindowDriver driver = CrowdedHall.open(folder);
                EventThreadMeter meter = EventThreadMeter.start()) {
            List<JTabbedPane> panes = callOnEdt(() ->
                    ComponentFinder.findAll(driver.window(), JTabbedPane.class).toList());
            for (JTabbedPane pane : panes) {
                for (int tab = pane.getTabCount() - 1; tab >= 0; tab--) {
                    int shown = tab;
                    runOnEdt(() -> pane.setSelectedIndex(shown));
                    driver.robot().waitForPaint();
                }
            }
            assertEquals(
                    List.of(),
                    meter.drain().stream()
                            .filter(stretch -> stretch.cpu() > MAX_BUSY_MILLIS)
                            .toList());
        }
    }

    @Test
    void changesOfLanguageAndTextSizeTakeShortEvents() throws IOException, ScenarioException {
        try (WindowDriver driver = CrowdedHall.open(folder)) {
            driver.runFast(frame -> frame.snapshot().time() > 10);
            try (EventThreadMeter meter = EventThreadMeter.start()) {
                for (String choice :
                        List.of("languagePolish", "textSizeLargest", "dark", "languageEnglish", "textSizeNormal")) {
                    driver.choose(choice);
                    driver.robot().waitForPaint();
                    driver.robot().waitForPaint();
                }
                List<EventThreadMeter.BusyPeriod> periods = meter.drain();
                System.out.println("busy with languages and text sizes: "
                        + DurationStatistics.of(periods.stream()
                                .map(EventThreadMeter.BusyPeriod::cpu)
                                .toList()));
                assertEquals(
                        List.of(),
                        periods.stream()
                                .filter(stretch -> stretch.cpu() > MAX_BUSY_MILLIS)
                                .toList());
            }
        }
    }

    /** Returns the periods that exceeded the bound in random use of a new window. */
    private List<EventThreadMeter.BusyPeriod> longBusyPeriods() {
        try (WindowDriver driver = CrowdedHall.open(folder)) {
            driver.runFast(frame -> frame.snapshot().time() > 60);
            return use(driver).stream()
                    .filter(stretch -> stretch.cpu() > MAX_BUSY_MILLIS)
                    .toList();
        } catch (IOException | ScenarioException broken) {
            throw new AssertionError(broken);
        }
    }

    private static List<EventThreadMeter.BusyPeriod> use(WindowDriver driver) {
        try (EventThreadMeter meter = EventThreadMeter.start()) {
            MonkeyTester user = new MonkeyTester(driver, SEED);
            int gestures = 0;
            long start = System.nanoTime();
            while (gestures < MIN_GESTURES || gestures < MAX_GESTURES && System.nanoTime() - start < MINUTE_NANOS) {
                user.performGesture();
                gestures++;
            }
            List<EventThreadMeter.BusyPeriod> stretches = meter.drain();
            System.out.println("busy during " + gestures + " gestures: "
                    + DurationStatistics.of(stretches.stream()
                            .map(EventThreadMeter.BusyPeriod::cpu)
                            .toList())
                    + "; by the clock "
                    + DurationStatistics.of(stretches.stream()
                            .map(EventThreadMeter.BusyPeriod::wall)
                            .toList()));
            assertTrue(
                    driver.frame().snapshot().obstacles().size() > CrowdedHall.SHAPES / 2, "the hall has been emptied");
            return stretches;
        }
    }
}
