package faultline.app;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import faultline.JavaProcess;
import faultline.campaign.plan.SamplePlan;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests campaigns in separate processes, which are killed while they run. */
class CampaignProcessTest {

    private static final int RUNS = 300;

    /** More runs than a machine makes before the test ends. */
    private static final int ENDLESS = 1_000_000;

    @TempDir
    Path folder;

    @BeforeEach
    void writePlan() throws IOException {
        Files.writeString(folder.resolve("room.xml"), SamplePlan.ROOM);
        writePlan(RUNS);
    }

    private void writePlan(int runs) throws IOException {
        Files.writeString(
                folder.resolve("plan.xml"),
                SamplePlan.text(
                        "",
                        "<worlds><scenario file=\"room.xml\"/></worlds><seeds count=\"" + runs
                                + "\"/><set attribute=\"robot/@speed\" value=\"0.1..0.5\"/>"));
    }

    private Process start(String... arguments) throws Exception {
        return builder(arguments).start();
    }

    private ProcessBuilder builder(String... arguments) {
        return builder(JavaProcess.program(), arguments);
    }

    private ProcessBuilder builder(List<String> command, String... arguments) {
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command)
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("output.txt").toFile());
    }

    private Process startCampaign(String out) throws Exception {
        return start("campaign", "plan.xml", "--out", out, "--jobs", "2", "--resume");
    }

    private byte[] finish(String out) throws Exception {
        Process process = startCampaign(out);
        assertTrue(process.waitFor(120, TimeUnit.SECONDS));
        assertEquals(0, process.exitValue(), Files.readString(folder.resolve("output.txt")));
        return Files.readAllBytes(folder.resolve(out).resolve("runs.csv"));
    }

    private void waitForBytes(String out, long bytes, Process process) throws Exception {
        Path table = folder.resolve(out).resolve("runs.csv");
        while (!Files.exists(table) || Files.size(table) < bytes) {
            if (process.waitFor(1, TimeUnit.MILLISECONDS)) {
                return;
            }
        }
    }

    @Test
    void aCampaignThatIsKilledAgainAndAgainGivesTheSameTable() throws Exception {
        byte[] expected = finish("whole");
        int halfway = 0;
        for (int part = 0; part < 5; part++) {
            Process process = startCampaign("killed");
            waitForBytes("killed", 1 + expected.length * part / 6, process);
            process.destroyForcibly().waitFor();
            halfway += madeRuns("killed") < RUNS ? 1 : 0;
        }
        assertTrue(halfway > 0, "no campaign was killed before its last row");
        assertArrayEquals(expected, finish("killed"));
        assertEquals(
                RUNS + 1,
                Files.readString(folder.resolve("killed/timing.csv")).lines().count());
        try (var files = Files.walk(folder.resolve("killed"))) {
            assertEquals(
                    List.of(),
                    files.filter(file -> file.toString().endsWith(".tmp")).toList());
        }
    }

    /** Such classes have no place, so the hash of the program is not known. */
    @Test
    void aProgramThatIsAppendedToTheClassesOfTheMachineMakesACampaign() throws Exception {
        writePlan(1);
        ProcessBuilder appended = builder("campaign", "plan.xml", "--out", "appended");
        appended.command().add(1, "-Xbootclasspath/a:" + JavaProcess.programClasses());
        Process process = appended.start();
        assertTrue(process.waitFor(120, TimeUnit.SECONDS));
        assertEquals(0, process.exitValue(), Files.readString(folder.resolve("output.txt")));
        assertTrue(Files.readString(folder.resolve("appended/campaign.json")).contains("\"program_sha256\": \"\""));
    }

    /** The verdict of a run at 6 km needs 1.9 million places. */
    @Test
    void aCampaignWithoutEnoughMemorySaysSo() throws Exception {
        Files.writeString(
                folder.resolve("plan.xml"),
                SamplePlan.text(
                        "",
                        "<worlds><scenario file=\"room.xml\"/></worlds>"
                                + "<set attribute=\"controller/@distance\" value=\"6000\"/>"));
        ProcessBuilder small = builder(JavaProcess.longProgram(), "campaign", "plan.xml", "--out", "small");
        small.command().add(1, "-Xmx48m");
        Process process = small.start();
        assertTrue(process.waitFor(120, TimeUnit.SECONDS));
        assertEquals("faultline: there is not enough memory\n", Files.readString(folder.resolve("output.txt")));
        assertEquals(ExitCode.RUN_FAILED, process.exitValue());
    }

    /**
     * Returns a campaign on a full disk, which a limit for the size of files represents: the table of the runs reaches
     * it before that of the times.
     */
    private ProcessBuilder limited() {
        ProcessBuilder limited = builder("campaign", "plan.xml", "--out", "limited", "--jobs", "1");
        // The data that a virtual machine gives to others are a file of 32 kB.
        limited.command().add(1, "-XX:-UsePerfData");
        limited.command().addAll(0, List.of("sh", "-c", "ulimit -f 20; exec \"$@\"", "sh"));
        return limited;
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "needs a terminal of its own")
    void anErrorStandsInALineBelowTheProgress() throws Exception {
        ProcessBuilder limited = limited();
        limited.command().addAll(0, List.of("python3", "-c", "import pty, sys; pty.spawn(sys.argv[1:])"));
        Process process = limited.start();
        process.getOutputStream().close();
        assertTrue(process.waitFor(120, TimeUnit.SECONDS));
        String shown = Files.readString(folder.resolve("output.txt"));
        assertTrue(shown.startsWith("\r["), shown);
        assertTrue(
                shown.endsWith(" left   \r\nfaultline: limited/runs.csv: the file cannot be written completely\r\n"),
                shown);
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "needs a shell that limits the size of files")
    void rowsThatCannotBeWrittenAreNotWrittenTwiceAtTheEnd() throws Exception {
        Process process = limited().start();
        assertTrue(process.waitFor(120, TimeUnit.SECONDS));
        assertEquals(
                "faultline: limited/runs.csv: the file cannot be written completely\n",
                Files.readString(folder.resolve("output.txt")));
        List<String> times = Files.readAllLines(folder.resolve("limited/timing.csv"));
        List<String> numbers =
                times.stream().skip(1).map(row -> row.split(",")[0]).toList();
        assertTrue(numbers.size() > 10, numbers::toString);
        assertEquals(
                IntStream.range(0, numbers.size()).mapToObj(Integer::toString).toList(), numbers);
    }

    @Test
    void anInterruptedCampaignEndsWithWholeRows() throws Exception {
        assumeTrue(ProcessHandle.current().supportsNormalTermination(), "needs a system with signals");
        String out = "interrupted-1";
        int exitCode = interrupt(out);
        // On a busy machine, the campaign may have made all runs before the signal.
        for (int i = 2; madeRuns(out) == RUNS; i++) {
            out = "interrupted-" + i;
            exitCode = interrupt(out);
        }
        assertEquals(143, exitCode);
        assertTrue(Files.readString(folder.resolve(out).resolve("runs.csv")).endsWith("\n"));
        assertTrue(madeRuns(out) > 20);
        assertEquals(
                "faultline: stopped after " + madeRuns(out) + " of " + RUNS + " runs; --resume makes the rest\n",
                Files.readString(folder.resolve("output.txt")));
        assertArrayEquals(finish("whole"), finish(out));
    }

    private long madeRuns(String out) throws IOException {
        return Files.readString(folder.resolve(out).resolve("runs.csv")).lines().count() - 1;
    }

    /** Starts a campaign, ends it by a signal when it has made some runs, and returns its exit code. */
    private int interrupt(String out) throws Exception {
        Process process = startCampaign(out);
        waitForBytes(out, 10_000, process);
        // Not SIGINT, which the children of a shell's background job ignore.
        process.destroy();
        assertTrue(process.waitFor(60, TimeUnit.SECONDS));
        return process.exitValue();
    }

    @Test
    void twoProcessesCannotMakeTheSameCampaign() throws Exception {
        writePlan(ENDLESS);
        Process first = startCampaign("shared");
        try {
            waitForBytes("shared", 1000, first);
            Process second = startCampaign("shared");
            assertTrue(second.waitFor(60, TimeUnit.SECONDS));
            assertEquals(2, second.exitValue());
            assertEquals(
                    "faultline: shared: another process is making this campaign\n",
                    Files.readString(folder.resolve("output.txt")));
        } finally {
            first.destroyForcibly().waitFor();
        }
    }

    @Test
    void badPlansAndBadUsageEndWithTwo() throws Exception {
        Files.writeString(folder.resolve("plan.xml"), SamplePlan.text("", "<worlds><rooms cuont=\"3\"/></worlds>"));
        Process process = startCampaign("bad");
        assertTrue(process.waitFor(60, TimeUnit.SECONDS));
        assertEquals(2, process.exitValue());
        assertEquals(
                "plan.xml:2:27: <rooms> has no attribute \"cuont\"; expected first, count, minCorner, visitors;"
                        + " did you mean \"count\"?\n",
                Files.readString(folder.resolve("output.txt")));
        assertTrue(Files.notExists(folder.resolve("bad")));
    }

    /** Begins a campaign when the process is already ending. */
    static final class LateProgram {

        private LateProgram() {}

        public static void main(String[] arguments) {
            CommandOutput output = new CommandOutput(System.out, System.err);
            Runtime.getRuntime().addShutdownHook(new Thread(() -> new CommandLine(output).run(arguments)));
        }
    }

    @Test
    void aCampaignThatBeginsWhileTheProcessEndsIsStopped() throws Exception {
        writePlan(ENDLESS);
        Process process = JavaProcess.builder(
                        LateProgram.class.getName(),
                        List.of(
                                "campaign",
                                folder.resolve("plan.xml").toString(),
                                "--out",
                                folder.resolve("late").toString()))
                .redirectErrorStream(true)
                .start();
        assertEquals(
                "faultline: " + folder.resolve("late/plan/plan.xml")
                        + ": the file was not written, because the program is ending\n",
                new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8));
    }
}
