package faultline.gui.window;

import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.DurationStatistics;
import faultline.gui.EdtChecker;
import faultline.gui.EventThreadMeter;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/**
 * Measures how long it takes to paint a floor plan as large as the public maps of whole buildings: 4700 rings with 23
 * 000 sides in 58 m x 47 m. The limit is that of sixty frames a second, of which an edit may delay a few.
 */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class FloorPlanPaintTimesRobotTest {

    private static final double FRAME_MILLIS = 1000.0 / 60;
    private static final double CELL = 0.05;
    private static final int RINGS = 4700;

    @TempDir
    private Path folder;

    @Test
    void aWholeBuildingIsPaintedAtSixtyFramesASecond() throws Exception {
        Path file = folder.resolve("building.xml");
        building().save(file);
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, file)) {
            driver.resizeCanvas(1200, 800);
            driver.choose("realTime");
            driver.choose("run");
            try (EventThreadMeter meter = EventThreadMeter.start()) {
                meter.drain();
                watch(driver, 3);
                check("running", meter);
                driver.choose("selectNext");
                watch(driver, 2);
                check("running with the plan selected", meter);
                nudge(driver, 20);
                DurationStatistics nudges = check("running while the plan is nudged", meter);
                assertTrue(nudges.p99() < 2 * FRAME_MILLIS, nudges::toString);
                for (int i = 0; i < 4; i++) {
                    driver.robot().drag(driver.canvas(), 20, 20, 320 - 40 * i, 220, InputEvent.BUTTON2_DOWN_MASK);
                }
                watch(driver, 1);
                check("panning", meter);
                driver.choose("follow");
                for (int i = 0; i < 8; i++) {
                    driver.choose("zoomIn");
                    watch(driver, 0.2);
                }
                check("zooming and following", meter);
            }
        }
    }

    private static void watch(WindowDriver driver, double seconds) {
        double from = driver.frame().snapshot().time();
        driver.waitForFrame("time passes", frame -> frame.snapshot().time() >= from + seconds);
    }

    /** Moves the selected plan to and fro, once in each frame. */
    private static void nudge(WindowDriver driver, int times) {
        driver.click(driver.canvas());
        for (int i = 0; i < times; i++) {
            Pose before = plan(driver.frame());
            driver.type(i % 2 == 0 ? KeyEvent.VK_UP : KeyEvent.VK_DOWN);
            driver.waitForFrame("the plan has moved", frame -> !plan(frame).equals(before));
        }
    }

    private static Pose plan(Frame frame) {
        return frame.snapshot().obstacles().get(0).pose();
    }

    private static DurationStatistics check(String what, EventThreadMeter meter) {
        List<Double> cpu = meter.drain().stream()
                .filter(EventThreadMeter.BusyPeriod::isPaint)
                .map(EventThreadMeter.BusyPeriod::cpu)
                .toList();
        DurationStatistics times = DurationStatistics.of(cpu);
        System.out.println("painting a building, " + what + ": " + times);
        assertTrue(times.median() < FRAME_MILLIS, () -> what + ": " + times);
        return times;
    }

    private static Scenario building() {
        Random random = new Random(11);
        List<List<Vector2>> rings = new ArrayList<>();
        double width = 58;
        double height = 47;
        int columns = 76;
        for (int i = 0; i < RINGS; i++) {
            double x = 1.5 + i % columns * (width - 3) / columns;
            double y = 1.5 + i / columns * (height - 3) / (RINGS / columns + 1);
            rings.add(ring(x, y, CELL * (1 + random.nextInt(3)), random.nextInt(4) == 0));
        }
        WorldSpec world = new WorldSpec(
                width,
                height,
                true,
                0,
                List.of(new Obstacle("plan", new ObstacleShape.PlanShape(rings), new Pose(0, 0, 0))));
        return new Scenario(
                "Building",
                "",
                false,
                SimulationSetup.of(world, new Pose(0.7, 0.7, 0)).withDuration(1800),
                Expectation.NONE);
    }

    /** A square, or an L of six sides. */
    private static List<Vector2> ring(double x, double y, double side, boolean bent) {
        double end = bent ? 2 * side : side;
        return bent
                ? List.of(
                        new Vector2(x, y),
                        new Vector2(x + end, y),
                        new Vector2(x + end, y + side),
                        new Vector2(x + side, y + side),
                        new Vector2(x + side, y + end),
                        new Vector2(x, y + end))
                : List.of(
                        new Vector2(x, y),
                        new Vector2(x + end, y),
                        new Vector2(x + end, y + end),
                        new Vector2(x, y + end));
    }
}
