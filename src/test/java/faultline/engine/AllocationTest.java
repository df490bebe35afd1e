package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import com.sun.management.ThreadMXBean;
import faultline.JavaProcess;
import faultline.control.ControllerSpec;
import faultline.geometry.Pose;
import faultline.world.WorldSpec;
import java.io.File;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
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

    /** Makes runs with other controllers, so that the virtual machine knows several. */
    private static void runOthers() {
        for (boolean diagnosis : new boolean[] {false, true}) {
            run(ControllerSpec.WallFollowing.DEFAULT.withDiagnosis(diagnosis));
        }
        run(new ControllerSpec.None());
    }

    private static void run(ControllerSpec controller) {
        Simulation simulation = new Simulation(
                SimulationSetup.of(new WorldSpec(4, 3, true, 0, List.of()), new Pose(2, 1.5, 0))
                        .withController(controller),
                ControllerMode.DIRECT);
        simulation.stopRecordingPath();
        for (int i = 0; i < TICKS; i++) {
            simulation.tick();
        }
    }

    /** Runs in a separate virtual machine, whose compiled code then depends only on its own runs. */
    static final class Probe {

        private Probe() {}

        /**
         * Prints the fewest bytes that some passes allocate; the first ones run before all code is compiled.
         *
         * @param args any for other runs before
         */
        public static void main(String[] args) {
            if (args.length > 0) {
                runOthers();
            }
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

    private static String probe(String... arguments) throws Exception {
        List<String> command = new ArrayList<>(List.of(
                JavaProcess.executable(),
                "-cp",
                place(Simulation.class) + File.pathSeparator + place(Probe.class),
                Probe.class.getName()));
        command.addAll(List.of(arguments));
        Process probe = new ProcessBuilder(command).redirectErrorStream(true).start();
        return JavaProcess.output(probe);
    }

    @Test
    void aTickAllocatesNothingIfNoOneShowsFrames() throws Exception {
        assertEquals("0", probe());
    }

    @Test
    void aTickAllocatesNothingAfterRunsWithOtherControllers() throws Exception {
        assertEquals("0", probe("others"));
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
