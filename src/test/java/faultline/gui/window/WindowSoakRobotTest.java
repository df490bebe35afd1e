package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.EdtChecker;
import faultline.gui.GuiRobot;
import faultline.gui.theme.Theme;
import java.awt.Window;
import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * Windows that run at full speed for long: memory stays flat, and every thread ends after they are closed in any order.
 * The system property {@code faultline.window.minutes} sets how long, by default some seconds.
 */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class WindowSoakRobotTest {

    private static final double MINUTES = Double.parseDouble(System.getProperty("faultline.window.minutes", "0.1"));
    private static final int SAMPLES = 12;
    private static final int THIRD = SAMPLES / 3;

    private static final long MAX_GROWTH = 16_000_000;
    private static final int ROUNDS = 3;
    private static final int MAX_TRIES = 1000;
    /** More than the number of events, each of which causes the next one, from the load of the guide to its display. */
    private static final int EVENTS_IN_TURN = 10;

    private static final List<Path> SCENARIOS = List.of(
            Path.of("scenarios/office.xml"),
            Path.of("scenarios/three-visitors.xml"),
            Path.of("scenarios/noisy-sensors.xml"));

    @Test
    void memoryStaysFlatAtFullSpeed() {
        List<Long> live = new ArrayList<>();
        long ticks = 0;
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, SCENARIOS.get(0))) {
            driver.runFast(frame -> frame.snapshot().time() > 1);
            for (int i = 0; i < SAMPLES; i++) {
                runFor(driver, TimeUnit.MINUTES.toNanos(1) * MINUTES / SAMPLES);
                live.add(liveBytes());
                long reached = driver.frame().snapshot().tick();
                assertNotEquals(ticks, reached, "the run has stopped");
                ticks = reached;
                System.out.println(String.format(
                        Locale.ROOT,
                        "window after %.1f minutes and %d ticks: %.1f MB",
                        MINUTES * (i + 1) / SAMPLES,
                        ticks,
                        live.get(i) / 1e6));
            }
        }
        assertTrue(least(live, SAMPLES - THIRD) - least(live, 0) < MAX_GROWTH, live.toString());
        assertTrue(ticks > 1000, ticks + " ticks");
    }

    /**
     * Returns the least of a third of the samples: when a path is thinned, or a layer painted, there are two of them.
     */
    private static long least(List<Long> samples, int from) {
        return samples.subList(from, from + THIRD).stream()
                .mapToLong(bytes -> bytes)
                .min()
                .orElseThrow();
    }

    /** Keeps a run going, which pauses at the end of its duration and at a collision. */
    private static void runFor(WindowDriver driver, double nanos) {
        long start = System.nanoTime();
        while (System.nanoTime() - start < nanos) {
            if (!callOnEdt(driver::isRunning)) {
                driver.choose(driver.frame().snapshot().collision().isPresent() ? "restart" : "run");
            }
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(50));
        }
    }

    /** Returns the size of the old generation after a collection, which moves all that is alive to it. */
    private static long liveBytes() {
        long before = fullCollections();
        // The call does nothing while native code, such as that which paints, holds an array.
        for (int tries = 0; tries < MAX_TRIES && fullCollections() == before; tries++) {
            System.gc();
        }
        assertNotEquals(before, fullCollections(), "no collection in " + MAX_TRIES + " tries");
        return ManagementFactory.getMemoryPoolMXBeans().stream()
                .filter(pool -> pool.getName().matches(".*(Old|Tenured) Gen"))
                .mapToLong(pool -> pool.getCollectionUsage().getUsed())
                .sum();
    }

    private static long fullCollections() {
        return ManagementFactory.getGarbageCollectorMXBeans().stream()
                .filter(collector -> collector.getName().matches(".*(Old|MarkSweep).*"))
                .mapToLong(GarbageCollectorMXBean::getCollectionCount)
                .sum();
    }

    @Test
    void everyThreadEndsAfterTheWindowsAreClosedInAnyOrder() {
        GuiRobot robot = new GuiRobot();
        SplittableRandom random = new SplittableRandom(31);
        for (int round = 0; round < ROUNDS; round++) {
            List<WindowDriver> open = new ArrayList<>();
            for (Path scenario : SCENARIOS) {
                WindowDriver driver = WindowDriver.open(Theme.LIGHT, scenario);
                driver.runFast(frame -> frame.snapshot().tick() > 0);
                open.add(driver);
            }
            assertTrue(ownThreads().size() >= SCENARIOS.size());
            while (!open.isEmpty()) {
                WindowDriver next = open.remove(random.nextInt(open.size()));
                if (random.nextBoolean()) {
                    next.choose("guide");
                }
                runOnEdt(() -> next.window().dispose());
            }
            robot.waitFor("the threads have ended", () -> ownThreads().isEmpty());
            assertEquals(List.of(), visibleWindows());
        }
    }

    /** Returns the windows that show after all events that are due, and those that they cause. */
    private static List<String> visibleWindows() {
        for (int i = 0; i < EVENTS_IN_TURN; i++) {
            runOnEdt(() -> {});
        }
        return callOnEdt(() -> Stream.of(Window.getWindows())
                .filter(Window::isShowing)
                .map(Window::toString)
                .toList());
    }

    private static List<String> ownThreads() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(Thread::isAlive)
                .map(Thread::getName)
                .filter(name -> name.startsWith("faultline-"))
                .toList();
    }
}
