package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import faultline.control.ControllerSpec;
import faultline.geometry.Pose;
import faultline.world.WorldSpec;
import java.lang.management.ManagementFactory;
import java.util.List;
import org.junit.jupiter.api.Test;

class AllocationTest {

    private static final int TICKS = 20_000;
    private static final int PASSES = 500;
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    /** A robot that drives circles in a room whose wall it sees on one side. */
    private static Simulation circling() {
        return new Simulation(
                SimulationSetup.of(new WorldSpec(3, 3, true, 0, List.of()), new Pose(1.5, 1.05, 0))
                        .withController(new ControllerSpec.Drive(2, 3)),
                ControllerMode.DIRECT);
    }

    /** Returns the fewest bytes that some passes allocate: the first ones run before all code is compiled. */
    private static long leastBytes(Simulation simulation) {
        long least = Long.MAX_VALUE;
        for (int pass = 0; pass < PASSES && least > 0; pass++) {
            long before = THREADS.getCurrentThreadAllocatedBytes();
            for (int i = 0; i < TICKS; i++) {
                simulation.tick();
            }
            least = Math.min(least, THREADS.getCurrentThreadAllocatedBytes() - before);
        }
        return least;
    }

    @Test
    void aTickAllocatesNothingIfNoOneShowsFrames() {
        try (Simulation simulation = circling()) {
            simulation.stopRecordingPath();
            assertEquals(0, leastBytes(simulation));
            assertTrue(simulation.collision().isEmpty());
        }
    }

    @Test
    void aPathThatIsNotRecordedChangesNothingElse() {
        try (Simulation shown = circling();
                Simulation unseen = circling()) {
            unseen.stopRecordingPath();
            for (int i = 0; i < 1000; i++) {
                shown.tick();
                unseen.tick();
            }
            assertEquals(shown.trajectoryHash(), unseen.trajectoryHash());
            assertNotEquals(shown.frame().path().size(), unseen.frame().path().size());
        }
    }
}
