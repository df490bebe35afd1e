package faultline.engine.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.recording.Recorder;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import faultline.world.WorldSpec;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

/**
 * The recordings of a run in the window are bounded: an hour of simulated time at full speed takes little more memory
 * than its first minutes.
 */
class MemoryGrowthTest {

    private static final long TICKS_PER_MINUTE = 6000;
    private static final long HOUR_MINUTES = 60;
    /** By now most of what is remembered is as large as it ever gets, minutes. */
    private static final long SETTLED_MINUTES = 20;

    /**
     * The path grows by 2.3 MB still, to end at 4.2, the hashes by 1.9, to end at 8, and the coarser traces by 2.3:
     * each of their levels reaches back four times as far as the one before and is full so much later. Bytes.
     */
    private static final long MAX_GROWTH = 8_000_000;

    /** The number of ticks between two frame requests, at about sixty requests per second. */
    private static final long TICKS_PER_FRAME = 2500;

    @Test
    void anHourAtFullSpeedNeedsHardlyMoreMemoryThanTwentyMinutes() {
        Map<Long, Long> live = new TreeMap<>();
        Recorder recorder = new Recorder(room());
        try (Simulation run = new Simulation(room(), ControllerMode.OWN_THREAD, recorder)) {
            recorder.observe(run);
            SessionFrame newest = SampleSessionFrames.unmeasured(run.frame(), recorder.view());
            while (run.ticks() < HOUR_MINUTES * TICKS_PER_MINUTE) {
                run.tick();
                recorder.observe(run);
                if (run.ticks() % TICKS_PER_FRAME == 0) {
                    newest = SampleSessionFrames.unmeasured(run.frame(), recorder.view());
                }
                if (run.ticks() % (10 * TICKS_PER_MINUTE) == 0) {
                    live.put(run.ticks() / TICKS_PER_MINUTE, liveBytes());
                }
            }
            assertEquals(HOUR_MINUTES * TICKS_PER_MINUTE, newest.snapshot().tick());
            assertTrue(newest.snapshot().collision().isEmpty());
        }
        live.forEach((minute, bytes) -> System.out.println(
                String.format(Locale.ROOT, "memory after %d simulated minutes: %.1f MB", minute, bytes / 1e6)));
        long growth = live.entrySet().stream()
                        .filter(e -> e.getKey() > SETTLED_MINUTES)
                        .mapToLong(Map.Entry::getValue)
                        .max()
                        .orElseThrow()
                - live.get(SETTLED_MINUTES);
        assertTrue(growth < MAX_GROWTH, "grown by " + growth + " bytes");
    }

    private static SimulationSetup room() {
        Obstacle desk = new Obstacle("desk", new ObstacleShape.RectangleShape(0.8, 0.4), new Pose(2.4, 2.5, 0.4));
        Obstacle visitor = new Obstacle(
                "visitor",
                new ObstacleShape.CircleShape(0.1),
                new Pose(3.6, 2, 0),
                new WaypointPath(0.2, true, List.of(new Vector2(3.6, 2), new Vector2(3.6, 3))));
        return SimulationSetup.of(new WorldSpec(6, 5, true, 3, List.of(desk, visitor)), new Pose(0.6, 0.6, 0.3))
                .withDuration(60);
    }

    /**
     * Returns the memory in use after garbage collections, the minimum of several measurements, because other threads
     * allocate at the same time.
     */
    private static long liveBytes() {
        return LongStream.generate(() -> {
                    System.gc();
                    return ManagementFactory.getMemoryMXBean()
                            .getHeapMemoryUsage()
                            .getUsed();
                })
                .limit(4)
                .min()
                .orElseThrow();
    }
}
