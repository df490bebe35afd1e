package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import com.sun.management.ThreadMXBean;
import faultline.control.ControllerSpec;
import faultline.geometry.Pose;
import faultline.world.WorldSpec;
import java.io.File;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
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

    /**
     * Runs in a virtual machine of its own: the compiler removes all objects of a tick only where one kind of run is
     * made.
     */
    static final class Probe {

        private Probe() {}

        /** Prints the fewest bytes that some passes allocate; the first ones run before all code is compiled. */
        public static void main(String[] args) {
            Simulation simulation = circling();
            simulation.stopRecordingPath();
            long least = Long.MAX_VALUE;
            for (int pass = 0; pass < PASSES && least > 0; pass++) {
                long before = THREADS.getCurrentThreadAllocatedBytes();
                for (int i = 0; i < TICKS; i++) {
                    simulation.tick();
                }
                least = Math.min(least, THREADS.getCurrentThreadAllocatedBytes() - before);
            }
            System.out.print(least + (simulation.collision().isEmpty() ? "" : ", collided"));
        }
    }

    private static String place(Class<?> type) throws Exception {
        return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI())
                .toString();
    }

    @Test
    void aTickAllocatesNothingIfNoOneShowsFrames() throws Exception {
        Process probe = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        place(Simulation.class) + File.pathSeparator + place(Probe.class),
                        Probe.class.getName())
                .redirectErrorStream(true)
                .start();
        assertEquals("0", new String(probe.getInputStream().readAllBytes(), StandardCharsets.UTF_8));
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
