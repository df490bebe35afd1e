package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import faultline.control.Observation;
import faultline.engine.RunFailedException;
import faultline.engine.SimulationSetup;
import faultline.gui.Await;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** A child has its time to end, also if the wait for its answer is interrupted. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
@Timeout(60)
class ChildEndTest {

    /**
     * Is busy until the file "go" exists, and saves its results when its input has ended. It ignores SIGTERM, so it has
     * both grace periods for that.
     */
    private static final String BUSY =
            """
            trap '' TERM
            : > busy
            while [ ! -e go ]; do sleep 0.01; done
            while read line; do :; done
            sleep 0.1
            echo saved > part
            mv part results
            """;

    private static final String READY = "read hello; echo '{\"type\":\"ready\",\"protocol\":1}'; read line\n";

    @TempDir
    private Path folder;

    private SimulationSetup setup;

    @BeforeEach
    void loadScenario() throws Exception {
        setup = Scenario.load(Path.of("scenarios/office.xml")).setup();
    }

    private String command(String script) throws IOException {
        Path file = Files.writeString(folder.resolve("child.sh"), "cd '" + folder + "'\n" + script);
        return "sh '" + file + "'";
    }

    private ExternalController start(String command) {
        RunDescription run = RunDescription.of("faultline test", "Office", setup, 1);
        return new ExternalController(command, run, ExternalController.Timeouts.DEFAULT, false, line -> {});
    }

    private static Observation observation(SimulationSetup setup) {
        return new Observation(
                0, setup.dt(), setup.robot(), new double[setup.robot().sensors().size()]);
    }

    /** Interrupts work while the child is busy, and lets the child continue after the work has ended. */
    private void interruptWhileBusy(Runnable work) throws Exception {
        Thread thread = new Thread(() -> {
            try {
                work.run();
            } catch (RunFailedException interrupted) {
                // The run is over.
            }
        });
        thread.start();
        Await.until("the busy child", () -> Files.exists(folder.resolve("busy")));
        thread.interrupt();
        thread.join();
        Files.createFile(folder.resolve("go"));
    }

    @Test
    void aChildThatIsBusyWithAnAnswerEndsInOrder() throws Exception {
        try (ExternalController child = start(command(READY + BUSY))) {
            interruptWhileBusy(() -> child.decide(observation(setup)));
        }
        assertTrue(Files.exists(folder.resolve("results")));
    }

    @Test
    void aChildWhoseStartIsCancelledEndsInOrder() throws Exception {
        String command = command(BUSY);
        interruptWhileBusy(() -> start(command).close());
        Await.until("the results", () -> Files.exists(folder.resolve("results")));
    }

    /** Closes a child on an interrupted thread, and exits at once. */
    static final class ClosingProgram {

        private ClosingProgram() {}

        @SuppressWarnings("resource")
        public static void main(String[] words) throws IOException {
            ChildProcess child = new ChildProcess(List.of(words), 1, line -> {});
            Thread.currentThread().interrupt();
            child.close();
            System.exit(0);
        }
    }

    @Test
    void theEndOfTheProgramLeavesAChildThatIsBeingClosedItsTime() throws Exception {
        Files.createFile(folder.resolve("go"));
        Process program = JavaProcess.start(ClosingProgram.class.getName(), ShellWords.split(command(BUSY)));
        assertTrue(program.waitFor(30, TimeUnit.SECONDS));
        assertEquals(0, program.exitValue());
        assertTrue(Files.exists(folder.resolve("results")));
    }

    /** Ends when its child has read an observation and written a line to standard error, and prints the failure. */
    static final class EndingProgram {

        private EndingProgram() {}

        public static void main(String[] words) throws Exception {
            SimulationSetup setup =
                    Scenario.load(Path.of("scenarios/office.xml")).setup();
            Thread user = Thread.currentThread();
            Runtime.getRuntime().addShutdownHook(new Thread(() -> awaitEnd(user)));
            try (ExternalController child = new ExternalController(
                    words[0],
                    RunDescription.of("faultline test", "Office", setup, 1),
                    ExternalController.Timeouts.DEFAULT,
                    false,
                    line -> new Thread(() -> System.exit(0)).start())) {
                child.decide(observation(setup));
            } catch (RunFailedException e) {
                System.out.println(e.getMessage());
            }
        }

        private static void awaitEnd(Thread thread) {
            try {
                thread.join();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }
    }

    @Test
    void aChildThatEndsWithTheProgramIsNotBlamed() throws Exception {
        String command = command(READY + "echo waiting >&2; exec sleep 1000\n");
        Process program = JavaProcess.builder(EndingProgram.class.getName(), List.of(command))
                .start();
        assertEquals(
                "the controller \"" + command + "\" was ended with the program at tick 0\n",
                new String(program.getInputStream().readAllBytes(), StandardCharsets.UTF_8));
        assertTrue(program.waitFor(30, TimeUnit.SECONDS));
    }
}
