package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import faultline.JavaProcess;
import faultline.engine.ControllerMode;
import faultline.engine.RunFailedException;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.gui.text.Translations;
import faultline.io.ShellText;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Good children give the trajectories of the built-in controller; bad ones end the run in one sentence. */
@EnabledOnOs(
        value = {OS.LINUX, OS.MAC},
        disabledReason = "the children of this test are shell scripts")
@Timeout(300)
class ExternalControllerTest {

    private static final String READY = "{\"type\":\"ready\",\"protocol\":1,\"name\":\"child\"}";
    /** The time limit of a child that does not answer, seconds. */
    private static final double PATIENCE = 0.5;

    /** The time limit of one that does, so that a machine on which programs start slowly changes no result, seconds. */
    private static final double LONG = 50;

    /** A window manager, for one, may be a child of the process that runs the tests. */
    private final Set<ProcessHandle> runningBefore =
            ProcessHandle.current().descendants().collect(Collectors.toSet());

    private final List<String> errors = Collections.synchronizedList(new ArrayList<>());

    /** In the last scenario a sensor of the following robot is switched off and then looks elsewhere. */
    @Test
    void aBuiltInControllerAsAChildGivesTheSameTrajectory(@TempDir Path folder) throws Exception {
        String changes =
                """
                <timeline>
                  <switch at="12" sensor="left" on="false"/>
                  <switch at="16" sensor="left" on="true"/>
                  <tune at="17" sensor="left" bearing="60"/>
                </timeline>
                <expect collision""";
        Path changed = Files.writeString(
                folder.resolve("changed.xml"),
                Files.readString(Path.of("scenarios/office.xml")).replace("<expect collision", changes));
        for (Path file : List.of(Path.of("scenarios/right-hand.xml"), Path.of("scenarios/every-fault.xml"), changed)) {
            SimulationSetup setup = Scenario.load(file).setup().withDuration(20);
            long expected =
                    HeadlessRun.run(setup, ControllerMode.DIRECT, List.of()).trajectoryHash();
            assertEquals(
                    expected,
                    run(javaChild("controller '" + file + "'"), setup, LONG).trajectoryHash(),
                    file::toString);
        }
    }

    private static String javaChild(String arguments) {
        return JavaProcess.program().stream().map(ShellText::quoted).collect(Collectors.joining(" ", "", " "))
                + arguments;
    }

    @Test
    void theChildIsAskedOnceATickAndInformedOfTheEnd() throws Exception {
        String child = "read hello; echo '" + READY + "'; i=0; while [ $i -lt 50 ]; do read line; "
                + "echo \"{\\\"type\\\":\\\"drive\\\",\\\"tick\\\":$i,\\\"v_m_s\\\":0.1,"
                + "\\\"omega_rad_s\\\":0}\"; i=$((i+1)); done; "
                + "read end; echo \"$end\" >&2";
        RunResult result = run(shell(child), office(), LONG);
        assertEquals(50, result.ticks());
        assertEquals(1, errors.size(), errors::toString);
        assertTrue(errors.get(0).contains("\"type\":\"end\""), errors::toString);
        assertTrue(errors.get(0).contains("\"reason\":\"duration\""), errors::toString);
    }

    /** Not beside other children: while one starts, its process may have what this one reads from open. */
    @Test
    void aChildThatHasClosedItsInputEndsTheRun() {
        String closed = "read l; exec 0<&-; echo '" + READY + "'; sleep 60";
        RunFailedException e = assertThrows(RunFailedException.class, () -> run(shell(closed), office(), LONG));
        assertTrue(e.getMessage().endsWith(" closed its standard input at tick 0"), e.getMessage());
        assertEquals(List.of(), childrenStillRunning());
    }

    private static String drive(String tick) {
        return "echo '{\"type\":\"drive\",\"tick\":" + tick + ",\"left_v\":1,\"right_v\":1}';";
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            textBlock =
                    """
            ,"name":"my follower"                              | my follower
            ,"name":"  my\\n\\tfollower \\u001b[31m\\u202e "     | my follower [31m
            ,"name":"dddddddddddddddddddddddddddddddddddddddddddddddddddddddddddddddd" | dddddddddddddddddddddddddddddddddddddddddddddddddddddddddddd...
            ,"name":"\\u0007"                                  | ``
            ,"name":null                                       | ``
            ,"name":"\\uffff a"                               | a
            ``                                                 | ``
            """)
    void theNameOfAChildIsOneShortLine(String member, String name) {
        String ready = "{\"type\":\"ready\",\"protocol\":1" + member + "}";
        String command = shell("read l; printf '%s\n' '" + ready + "'; read l");
        RunDescription run = RunDescription.of("faultline test", "Office", office(), 1);
        try (ExternalController child =
                new ExternalController(command, run, ExternalController.Timeouts.DEFAULT, false, errors::add)) {
            assertEquals(name, child.name());
        }
    }

    @Test
    void anAnswerAfterALongSilenceIsWhole() throws Exception {
        String slow = "read l; echo '" + READY + "'; read l; sleep 1.5; " + drive("0")
                + " read l; printf '{\"type\":'; sleep 1.5; echo '\"drive\",\"tick\":1,\"left_v\":1,\"right_v\":1}'; "
                + "read l; " + drive("2") + " read l";
        assertEquals(3, run(shell(slow), office().withDuration(0.03), LONG).ticks());
    }

    @Test
    void aSecondAnswerIsFoundAtTheNextTick() {
        String twice =
                "read l; echo '" + READY + "'; read l; A='{\"type\":\"drive\",\"tick\":0,\"left_v\":1,\"right_v\":1}'; "
                        + "echo $A; echo $A; read l; read l";
        RunFailedException e = assertThrows(RunFailedException.class, () -> run(shell(twice), office(), LONG));
        assertTrue(e.getMessage().contains("answered tick 0 at tick 1"), e.getMessage());
    }

    @Test
    void aSecondAnswerToTheLastObservationIsFoundAtTheEnd() throws Exception {
        String ready = "read l; echo '" + READY + "'; read l; " + drive("0") + " ";
        SimulationSetup setup = office().withDuration(0.01);
        for (String extra : List.of(drive("0"), "read l; sleep 0.5; " + drive("0"))) {
            String command = shell(ready + extra);
            RunFailedException e = assertThrows(RunFailedException.class, () -> run(command, setup, LONG));
            assertEquals(
                    "the controller \"" + command
                            + "\" answered more often than it was asked; expected one answer for each observation",
                    e.getMessage());
            Translations.assertTranslated(e.reason());
        }
        assertEquals(
                1,
                run(shell(ready + "echo the end; echo more; printf '{\"type\":\"drive'"), setup, LONG)
                        .ticks());
        assertEquals(List.of(), childrenStillRunning());
    }

    /** A child may answer each line, also the end, which has no tick. */
    @ParameterizedTest
    @ValueSource(strings = {",\"tick\":0", ",\"tick\":2", ""})
    void anAnswerToTheEndIsIgnored(String tick) throws Exception {
        String child = "read l; echo '" + READY + "'; read l; " + drive("0") + " read l; " + drive("1")
                + " read l; echo '{\"type\":\"drive\"" + tick + ",\"left_v\":1,\"right_v\":1}'";
        assertEquals(2, run(shell(child), office().withDuration(0.02), LONG).ticks());
    }

    @Test
    void theLastLinesOnStandardErrorAreKeptWithTheFailure() {
        String flood = "read l; for i in $(seq 3000); do echo line $i >&2; done; exit 1";
        RunFailedException e = assertThrows(RunFailedException.class, () -> run(shell(flood), office(), LONG));
        assertTrue(
                e.getMessage().contains("; its last line on standard error: line 3000; the lines before: line 2981 | "),
                e.getMessage());
        assertTrue(e.getMessage().endsWith("line 2999"), e.getMessage());
        assertEquals(3000, errors.size());
    }

    /** The last character of either line is a pair of surrogates. */
    @Test
    void aLongLineOnStandardErrorIsShownAndAVeryLongOneIsMarked() {
        String face = "\\360\\237\\230\\200";
        String lines = "read l; printf '%09998d" + face + "\\n%09999d" + face + "\\n' 0 0 >&2; exit 1";
        RunFailedException e = assertThrows(RunFailedException.class, () -> run(shell(lines), office(), LONG));
        assertEquals(List.of("0".repeat(9998) + "\uD83D\uDE00", "0".repeat(9999) + "..."), errors);
        String kept = "0".repeat(400) + "...";
        assertTrue(
                e.getMessage().endsWith("its last line on standard error: " + kept + "; the lines before: " + kept),
                e.getMessage());
    }

    @Test
    void aChildThatReadsNothingCannotHoldUpTheRun() {
        String deaf = String.join(
                " ", JavaProcess.builder(DeafChild.class.getName(), List.of()).command());
        SimulationSetup setup = office().withDuration(1000);
        RunFailedException e = assertThrows(RunFailedException.class, () -> run(deaf, setup, 4 * PATIENCE));
        assertTrue(e.getMessage().contains("does not read its standard input"), e.getMessage());
        assertEquals(List.of(), childrenStillRunning());
    }

    @Test
    void descendantsEndWithTheChild() {
        String script = "sleep 1000 & read l; exit 1";
        assertThrows(RunFailedException.class, () -> run(shell(script), office(), LONG));
        assertEquals(List.of(), childrenStillRunning());
    }

    @Test
    void aProcessThatHasLeftTheChildsFamilyEndsToo() {
        String length = Long.toString(1_000_000 + ProcessHandle.current().pid());
        String script = "(sleep " + length + " &); (setsid sleep " + length + " &); read l; sleep 0.2; exit 1";
        assertEquals(List.of(), leftWith("sleep " + length, script));
    }

    @Test
    void aProcessThatHasLeftTheFamilyAndLostItsEnvironmentEndsToo() {
        String length = Long.toString(2_000_000 + ProcessHandle.current().pid());
        String script = "(setsid env -i sleep " + length + " &); read l; sleep 0.2; exit 1";
        assertEquals(List.of(), leftWith("sleep " + length, script));
    }

    /** Each process of a chain starts the next one and ends, so a search of all processes may just miss it. */
    @Test
    void processesThatStartOthersMeanwhileEndToo() {
        String token = "chain-" + ProcessHandle.current().pid();
        String link = "sleep 0.03; [ $n -lt 1000 ] && n=$((n+1)) sh -c \"$link\" " + token + " &";
        String script = "export n=0 link='" + link + "'; for i in 1 2 3 4 5 6 7 8; do (setsid sh -c \"$link\" " + token
                + " &); done; read l; sleep 0.2; exit 1";
        assertEquals(List.of(), leftWith(token, script));
    }

    /** Runs a child that breaks the run, and returns the processes that are left and whose last argument is given. */
    private List<String> leftWith(String ending, String script) {
        assumeTrue(OS.current() == OS.LINUX, "found by /proc");
        assertThrows(RunFailedException.class, () -> run(shell(script), office(), LONG));
        return ProcessHandle.allProcesses()
                .map(process -> process.info().commandLine().orElse(""))
                .filter(command -> command.endsWith(ending))
                .toList();
    }

    @Test
    void aChildThatFloodsStandardErrorDrivesOn() throws Exception {
        String flood = "read hello; echo '" + READY + "'; i=0; while [ $i -lt 50 ]; do read line; "
                + "seq 2000 >&2; echo \"{\\\"type\\\":\\\"drive\\\",\\\"tick\\\":$i,\\\"v_m_s\\\":0.1,"
                + "\\\"omega_rad_s\\\":0}\"; i=$((i+1)); done; read end";
        assertEquals(50, run(shell(flood), office(), LONG).ticks());
        assertEquals(100_000, errors.size());
    }

    @Test
    void aProgramThatIsNotThereIsReported() {
        ControllerStartException e =
                assertThrows(ControllerStartException.class, () -> run("no-such-program --x", office(), LONG));
        assertEquals(
                "the controller \"no-such-program --x\" cannot be started: there is no such program", e.getMessage());
    }

    @Test
    void aWordThatNoProgramHasNamesTheControllersOfTheProgram() {
        String message = assertThrows(ControllerStartException.class, () -> run("built-in", office(), LONG))
                .getMessage();
        assertTrue(message.endsWith("; names of controllers are wall-follower, none"), message);
        String path = assertThrows(ControllerStartException.class, () -> run("/no/built-in", office(), LONG))
                .getMessage();
        assertFalse(path.contains("wall-follower"), path);
    }

    /** The child writes more than fits in a pipe, and would be ended by a write after that if the pipe were closed. */
    @Test
    void aConsumerOfErrorsThatFailsDoesNotStopAChild() throws Exception {
        String child =
                "read hello; yes " + "x".repeat(999) + " | head -n 200 >&2; echo last >&2; echo '" + READY + "'; "
                        + "i=0; while [ $i -lt 50 ]; do read line; echo \"{\\\"type\\\":\\\"drive\\\",\\\"tick\\\":$i,"
                        + "\\\"v_m_s\\\":0.1,\\\"omega_rad_s\\\":0}\"; i=$((i+1)); done; read end";
        AtomicInteger lines = new AtomicInteger();
        RunResult result = run(shell(child), office(), LONG, LONG, line -> {
            lines.incrementAndGet();
            throw new IllegalStateException("full");
        });
        assertEquals(50, result.ticks());
        assertEquals(201, lines.get());
    }

    /** Returns the descendants of this process that a test has started and that still run. */
    private List<String> childrenStillRunning() {
        return ProcessHandle.current()
                .descendants()
                .filter(child -> !runningBefore.contains(child))
                .filter(ProcessHandle::isAlive)
                .map(child -> child.info().commandLine().orElse("?"))
                .toList();
    }

    static SimulationSetup office() {
        try {
            return Scenario.load(Path.of("scenarios/office.xml")).setup().withDuration(0.5);
        } catch (ScenarioException e) {
            throw new IllegalStateException(e);
        }
    }

    static String shell(String script) {
        return "sh -c \"" + script.replace("\\", "\\\\").replace("\"", "\\\"") + "\"";
    }

    private RunResult run(String command, SimulationSetup setup, double patience) throws IOException {
        return run(command, setup, LONG, patience, errors::add);
    }

    static RunResult run(String command, SimulationSetup setup, double start, double patience, Consumer<String> errors)
            throws IOException {
        RunDescription run = RunDescription.of("faultline test", "Office", setup, 1);
        try (ExternalController child =
                new ExternalController(command, run, new ExternalController.Timeouts(start, patience), false, errors)) {
            RunResult result = HeadlessRun.run(setup, child, ControllerMode.DIRECT, List.of());
            child.finish("duration", "0", Map.of());
            return result;
        }
    }

    @ParameterizedTest
    @CsvSource({"NaN, 10", "30, NaN", "0, 10", "30, 0", "-1, 10"})
    void timeLimitsArePositive(double ready, double answer) {
        IllegalArgumentException e =
                assertThrows(IllegalArgumentException.class, () -> new ExternalController.Timeouts(ready, answer));
        assertEquals("time limits must be positive: " + ready + ", " + answer, e.getMessage());
    }
}
