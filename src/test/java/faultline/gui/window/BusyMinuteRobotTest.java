package faultline.gui.window;

import static faultline.gui.GuiRobot.edt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.EdtChecker;
import faultline.gui.EventMeter;
import faultline.gui.Times;
import faultline.gui.theme.Theme;
import faultline.scenario.ScenarioException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/**
 * How long the event dispatch thread is busy at a stretch while somebody tries everything for a minute, in a hall of 500 shapes and with
 * the run at full speed. What is held to the bound is the thread's own processor time, because other programs on the machine do not
 * lengthen it; the time by the clock is printed beside it. Nothing is warmed up: the first use of a dialog counts.
 */
@ExtendWith(EdtChecker.class)
@DisabledIf(value = "java.awt.GraphicsEnvironment#isHeadless", disabledReason = "drives a real window, which needs a display")
class BusyMinuteRobotTest {

    /** Milliseconds. */
    private static final double MOST = 50;
    private static final long SEED = 11;
    private static final int LEAST_GESTURES = 30;
    private static final long MINUTE = TimeUnit.SECONDS.toNanos(60);

    @TempDir
    private Path folder;

    @AfterEach
    void lightAgain() {
        edt(Theme.LIGHT::install);
    }

    @Test
    void inAMinuteOfRandomUseTheWindowIsNeverBusyForLong() {
        assertEquals(List.of(), longStretches());
    }

    /** What kept the thread for too long in a minute of use of a new window. */
    private List<EventMeter.Stretch> longStretches() {
        try (WindowDriver driver = CrowdedHall.open(folder)) {
            driver.runFast(frame -> frame.world().time() > 60);
            return use(driver).stream().filter(stretch -> stretch.cpu() > MOST).toList();
        } catch (IOException | ScenarioException broken) {
            throw new AssertionError(broken);
        }
    }

    private static List<EventMeter.Stretch> use(WindowDriver driver) {
        try (EventMeter meter = EventMeter.start()) {
            RandomUser user = new RandomUser(driver, SEED);
            int gestures = 0;
            for (long start = System.nanoTime(); System.nanoTime() - start < MINUTE; gestures++) {
                user.act();
            }
            List<EventMeter.Stretch> stretches = meter.take();
            System.out.println("busy in a minute of " + gestures + " gestures: "
                    + Times.of(stretches.stream().map(EventMeter.Stretch::cpu).toList())
                    + "; by the clock " + Times.of(stretches.stream().map(EventMeter.Stretch::wall).toList()));
            assertTrue(gestures > LEAST_GESTURES, gestures + " gestures");
            assertTrue(driver.frame().world().obstacles().size() > CrowdedHall.SHAPES / 2, "the hall has been emptied");
            return stretches;
        }
    }
}
