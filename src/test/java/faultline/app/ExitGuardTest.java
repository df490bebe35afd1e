package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import faultline.control.Controller;
import faultline.control.ControllerProvider;
import faultline.control.Decision;
import faultline.io.JsonParser;
import faultline.robot.Velocity;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Controllers in Java that end the process, or leave something that would prevent its end. */
@Timeout(120)
class ExitGuardTest {

    private static final String MESSAGE =
            "faultline: the run broke: the controller has ended the program by System.exit\n";

    /** The variable with which the controllers end the process when they are asked for their name. */
    private static final String NAMELESS = "FAULTLINE_TEST_NAMELESS";

    /** The variable with which the controllers leave a thread that does not end. */
    private static final String LEAVES_THREAD = "FAULTLINE_TEST_LEAVES_THREAD";

    private static final Path YARD = Path.of("scenarios/yard.xml");

    @TempDir
    private Path folder;

    /** Makes controllers that end the process at tick 7. */
    public static final class Quitters implements ControllerProvider {

        @Override
        public String name() {
            if (System.getenv().containsKey(NAMELESS)) {
                System.exit(0);
            }
            return "quitter";
        }

        @Override
        public Controller create(Map<String, String> settings) {
            if (System.getenv().containsKey(LEAVES_THREAD)) {
                Thread left = new Thread(LockSupport::park);
                // A thread inherits this from the one that calls create, which is a daemon.
                left.setDaemon(false);
                left.start();
            }
            return observation -> {
                if (settings.containsKey("err")) {
                    spoilStandardError(settings.get("err"));
                    throw new IllegalStateException("spoilt");
                } else if (settings.containsKey("stays")) {
                    System.out.println("tick " + observation.tick());
                    System.out.close();
                } else if (observation.tick() == 7 && settings.isEmpty()) {
                    System.exit(0);
                }
                return Decision.ofVelocity(observation.robot(), new Velocity(0, 0), "WAIT", "");
            };
        }
    }

    /** Closes standard error, or locks it until the process ends. */
    private static void spoilStandardError(String how) {
        if (how.equals("closed")) {
            System.err.close();
            return;
        }
        CountDownLatch locked = new CountDownLatch(1);
        Thread owner = new Thread(() -> {
            synchronized (System.err) {
                locked.countDown();
                await(new CountDownLatch(1));
            }
        });
        owner.setDaemon(true);
        owner.start();
        await(locked);
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    private Process start(String mainClass, String... arguments) throws IOException {
        return builder(mainClass, arguments).start();
    }

    private ProcessBuilder builder(String mainClass, String... arguments) throws IOException {
        Path services = Files.createDirectories(folder.resolve("classes/META-INF/services"));
        Files.writeString(services.resolve(ControllerProvider.class.getName()), Quitters.class.getName());
        ProcessBuilder builder = JavaProcess.builder(mainClass, List.of(arguments));
        List<String> command = new ArrayList<>(builder.command());
        int classPath = command.indexOf("-cp") + 1;
        command.set(classPath, folder.resolve("classes") + File.pathSeparator + command.get(classPath));
        return builder.command(command).redirectErrorStream(true);
    }

    @Test
    void aRunWhoseControllerEndsTheProcessBreaksAndLeavesNoFiles() throws Exception {
        Path out = Files.createDirectory(folder.resolve("out"));
        Process process = start(
                "faultline.app.Main",
                "run",
                "scenarios/yard.xml",
                "--controller",
                "quitter",
                "--trace",
                out.resolve("trace.csv").toString());
        assertEquals(MESSAGE, JavaProcess.output(process));
        assertEquals(ExitCode.RUN_FAILED, process.waitFor());
        try (Stream<Path> files = Files.list(out)) {
            assertEquals(List.of(), files.toList());
        }
    }

    @Test
    void aComparisonWhoseControllerEndsTheProcessBreaks() throws Exception {
        Process process = start(
                "faultline.app.Main",
                "compare",
                "scenarios/yard.xml",
                "--controller",
                "none",
                "--controller",
                "quitter",
                "--until",
                "1",
                "--out",
                folder.resolve("page.html").toString());
        assertEquals(MESSAGE, JavaProcess.output(process));
        assertEquals(ExitCode.RUN_FAILED, process.waitFor());
    }

    @ParameterizedTest
    @ValueSource(strings = {"run", "check", "serve"})
    void aControllerThatEndsTheProcessInsteadOfSayingItsNameIsReported(String command) throws Exception {
        Path file = Files.writeString(
                folder.resolve("quit.xml"),
                Files.readString(YARD).replace("<expect", "<controller type='quitter'/><expect"));
        ProcessBuilder builder = builder("faultline.app.Main", command, file.toString());
        builder.environment().put(NAMELESS, "1");
        Process process = builder.start();
        process.getOutputStream().close();
        assertEquals(MESSAGE, JavaProcess.output(process));
        assertEquals(ExitCode.RUN_FAILED, process.waitFor());
    }

    /** Without a display, a file alone is run, too. */
    @ParameterizedTest
    @ValueSource(strings = {"run FILE", "compare FILE --controller none --controller quitter --out PAGE", "FILE"})
    void aThreadThatAControllerLeavesDoesNotPreventTheEnd(String command) throws Exception {
        Path file = Files.writeString(
                folder.resolve("left.xml"),
                Files.readString(YARD)
                        .replace("duration=\"120\"", "duration=\"0.05\"")
                        .replaceAll("<expect[^>]*/>", "<controller type='quitter'/>"));
        String[] arguments = command.replace("FILE", file.toString())
                .replace("PAGE", folder.resolve("page.html").toString())
                .split(" ");
        ProcessBuilder builder =
                builder("faultline.app.Main", arguments).redirectOutput(ProcessBuilder.Redirect.DISCARD);
        builder.command().add(1, "-Djava.awt.headless=true");
        builder.environment().put(LEAVES_THREAD, "1");
        Process process = builder.start();
        try {
            assertTrue(process.waitFor(60, TimeUnit.SECONDS), "the process ends");
            assertEquals(ExitCode.SUCCESS, process.exitValue());
        } finally {
            process.destroyForcibly();
        }
    }

    @Test
    void whatAControllerPrintsIsNotPartOfTheResult() throws Exception {
        Path file = Files.writeString(
                folder.resolve("quit.xml"),
                Files.readString(YARD)
                        .replace(
                                "<expect",
                                "<controller type='quitter'><setting name='stays' value='1'/></controller><expect"));
        Process process = builder("faultline.app.Main", "run", file.toString(), "--until", "0.1", "--json")
                .redirectErrorStream(false)
                .redirectError(folder.resolve("errors").toFile())
                .start();
        String result = JavaProcess.output(process);
        assertTrue(JsonParser.parse(result.strip()) instanceof Map, result);
        assertTrue(Files.readString(folder.resolve("errors")).startsWith("tick 0" + System.lineSeparator()));
    }

    @ParameterizedTest
    @ValueSource(strings = {"closed", "locked"})
    void aControllerDoesNotKeepTheProgramFromWritingItsMessage(String how) throws Exception {
        Path file = Files.writeString(
                folder.resolve("spoilt.xml"),
                Files.readString(YARD)
                        .replace(
                                "<expect",
                                "<controller type='quitter'><setting name='err' value='" + how
                                        + "'/></controller><expect"));
        Process process = start("faultline.app.Main", "run", file.toString());
        try {
            assertTrue(process.waitFor(60, TimeUnit.SECONDS), "it ends");
            String message = JavaProcess.output(process);
            assertTrue(message.contains(": java.lang.IllegalStateException: spoilt"), message);
        } finally {
            process.destroyForcibly();
        }
    }

    /** Ends the process by itself, after or without a guard, or by another thread. */
    static final class GuardedProgram {

        private GuardedProgram() {}

        public static void main(String[] arguments) throws InterruptedException {
            ExitGuard guard = ExitGuard.start(new CommandOutput(System.out, System.err));
            if (!arguments[0].equals("guarded")) {
                guard.close();
                if (!arguments[0].equals("closed")) {
                    // The end of the process has started this hook, and the run has ended since.
                    Runtime.getRuntime().addShutdownHook(new Thread(guard::report));
                }
                if (!arguments[0].equals("ended by another")) {
                    System.exit(5);
                }
                new Thread(() -> System.exit(5)).start();
            } else {
                System.out.println("ready");
            }
            Thread.currentThread().join();
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"closed", "signalled"})
    void afterItsEndTheGuardChangesNoExitCode(String end) throws Exception {
        Process process = start(GuardedProgram.class.getName(), end);
        assertEquals("", JavaProcess.output(process));
        assertEquals(5, process.waitFor());
    }

    /** The end of the process cancels a campaign, whose end closes the guard. */
    @Test
    void anEndByTheControllerIsReportedAlsoIfItEndsTheRun() throws Exception {
        Process process = start(GuardedProgram.class.getName(), "ended by another");
        assertEquals(MESSAGE, JavaProcess.output(process));
        assertEquals(ExitCode.RUN_FAILED, process.waitFor());
    }

    /** Returns the signals that end a program; the children of a shell's background job ignore SIGINT. */
    private static Stream<String> signals() throws IOException {
        Path status = Path.of("/proc/self/status");
        boolean ignoresInterrupts = Files.exists(status)
                && Files.readAllLines(status).stream().anyMatch(line -> line.matches("SigIgn:.*[2367abef]"));
        return ignoresInterrupts ? Stream.of("-TERM") : Stream.of("-INT", "-TERM");
    }

    @ParameterizedTest
    @MethodSource("signals")
    void aSignalIsNoEndByTheController(String signal) throws Exception {
        Process process = start(GuardedProgram.class.getName(), "guarded");
        assertEquals('r', process.getInputStream().read());
        JavaProcess.signal(signal, process.toHandle());
        assertEquals("eady\n", JavaProcess.output(process));
        assertEquals(signal.equals("-INT") ? 130 : 143, process.waitFor());
    }
}
