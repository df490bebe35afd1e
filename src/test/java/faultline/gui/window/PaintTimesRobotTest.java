package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vector2;
import faultline.gui.DurationStatistics;
import faultline.gui.EdtChecker;
import faultline.gui.EventThreadMeter;
import faultline.gui.canvas.SimulationCanvas;
import faultline.world.Obstacle;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntConsumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/**
 * Measures how long it takes to paint 500 shapes, eight cones and a path of 100 000 points on a canvas of 1200 x 800
 * pixels during a run and during drags. The limits apply to the processor time of the event dispatch thread, because
 * other programs on the machine do not increase it; the elapsed time is printed as well.
 */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class PaintTimesRobotTest {

    /** Milliseconds. */
    private static final double MAX_MEDIAN = 12;

    private static final double MAX_P99 = 24;

    /** Shorter paints, in milliseconds, are those of labels beside the canvas. */
    private static final double MIN_CANVAS_PAINT = 0.4;

    private static final int LONG_PATH = 100_000;

    private final List<Double> all = new ArrayList<>();

    @TempDir
    private Path folder;

    private WindowDriver driver;
    private EventThreadMeter meter;

    @BeforeEach
    void open() throws Exception {
        driver = CrowdedHall.open(folder);
        driver.choose("instruments");
        driver.resizeCanvas(1200, 800);
        driver.runFast(frame -> frame.path().size() >= LONG_PATH);
        driver.choose("realTime");
        meter = EventThreadMeter.start();
    }

    @AfterEach
    void close() {
        meter.close();
        driver.close();
    }

    @Test
    void everyFrameIsPaintedWithinTheLimits() {
        assertEquals(8, driver.frame().snapshot().sensors().size());
        assertEquals(CrowdedHall.SHAPES, driver.frame().snapshot().obstacles().size());
        watch();
        DurationStatistics times = measureAll();
        assertTrue(times.median() < MAX_MEDIAN && times.p99() < MAX_P99, times::toString);
    }

    private DurationStatistics measureAll() {
        meter.drain();
        measure("running", this::watch);
        measure("panning", this::pan);
        measure("zooming by the wheel", () -> repeat(10, turn -> driver.robot().rotateWheel(turn < 5 ? -1 : 1)));
        measure("fitting", () -> driver.choose("fit"));
        measure("dragging an obstacle", this::dragAnObstacle);
        measure("undoing and redoing", () -> repeat(10, turn -> driver.choose(turn % 2 == 0 ? "undo" : "redo")));
        measure("selecting all", () -> driver.choose("selectAll"));
        measure("dragging all", this::dragAnObstacle);
        measure("switching sensors", () -> repeat(4, turn -> driver.robot().pressKeys(KeyEvent.VK_1 + turn % 4)));
        measure("names on and off", () -> repeat(4, turn -> driver.choose("labels")));
        measure("path on and off", () -> repeat(4, turn -> driver.choose("path")));
        measure("dark and light", () -> repeat(2, turn -> driver.choose("dark")));
        measure(
                "resizing",
                () -> repeat(4, turn -> driver.resizeCanvas(1200 - 20 * (turn % 2), 800 - 10 * (turn % 2))));
        measure("with a ghost, panning", this::panWithReferenceRun);
        measure("following the robot", this::followRobot);
        DurationStatistics times = DurationStatistics.of(all);
        System.out.println("painting, all:                    " + times);
        return times;
    }

    private void pan() {
        drag(InputEvent.BUTTON2_DOWN_MASK, 20, 20, 320, 220);
    }

    private void dragAnObstacle() {
        Obstacle obstacle = driver.frame().snapshot().obstacles().get(30);
        Vector2 from =
                callOnEdt(() -> canvas().camera().toScreen(obstacle.pose().position()));
        drag(InputEvent.BUTTON1_DOWN_MASK, from.x(), from.y(), from.x() + 60, from.y() + 35);
    }

    private void panWithReferenceRun() {
        driver.choose("keepGhost");
        driver.waitForReferenceRun();
        pan();
    }

    private void followRobot() {
        repeat(6, turn -> driver.choose("zoomIn"));
        driver.choose("follow");
        watch();
    }

    private void drag(int button, double fromX, double fromY, double toX, double toY) {
        driver.robot().drag(canvas(), fromX, fromY, toX, toY, button);
        driver.robot().drag(canvas(), toX, toY, fromX, fromY, button);
    }

    /** Repeats an action, watching its effect for a moment each time. */
    private void repeat(int times, IntConsumer action) {
        for (int turn = 0; turn < times; turn++) {
            action.accept(turn);
            watch(0.1);
        }
    }

    private void watch() {
        watch(2);
    }

    /** Lets simulated seconds pass. */
    private void watch(double seconds) {
        double from = driver.frame().snapshot().time();
        driver.waitForFrame("time passes", frame -> frame.snapshot().time() >= from + seconds);
    }

    private SimulationCanvas canvas() {
        return driver.canvas();
    }

    private void measure(String what, Runnable action) {
        meter.drain();
        action.run();
        watch(0.5);
        List<EventThreadMeter.BusyPeriod> paints = meter.drain().stream()
                .filter(stretch -> stretch.isPaint() && stretch.cpu() > MIN_CANVAS_PAINT)
                .toList();
        List<Double> cpu = paints.stream().map(EventThreadMeter.BusyPeriod::cpu).toList();
        all.addAll(cpu);
        System.out.printf(
                "painting, %-22s  %s; by the clock %s%n",
                what + ":",
                DurationStatistics.of(cpu),
                DurationStatistics.of(
                        paints.stream().map(EventThreadMeter.BusyPeriod::wall).toList()));
    }
}
