package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import faultline.JavaProcess;
import faultline.campaign.plan.SamplePlan;
import faultline.engine.RunFailedException;
import faultline.engine.metrics.HeadlessRun;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioLimits;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Commands whose outputs would destroy an input or each other, and outputs that cannot be completed. */
class OutputFilesTest {

    private static final Path SCENARIO = Path.of("scenarios/struck-by-a-visitor.xml");

    @TempDir
    private Path folder;

    /** Runs a command that must be refused, and returns its message. */
    private static String refusal(Object... arguments) {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        PrintStream out = new PrintStream(new ByteArrayOutputStream(), true, StandardCharsets.UTF_8);
        String[] texts = Stream.of(arguments).map(Object::toString).toArray(String[]::new);
        int code =
                new CommandLine(new CommandOutput(out, new PrintStream(err, true, StandardCharsets.UTF_8))).run(texts);
        String message = err.toString(StandardCharsets.UTF_8);
        assertEquals(2, code, message);
        assertEquals(1, message.lines().count(), message);
        return message;
    }

    private Path scenario() throws IOException {
        return Files.copy(SCENARIO, folder.resolve("a.xml"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"--trace", "--image", "--journal"})
    void anOutputThatIsTheScenarioByALinkIsRefused(String option) throws IOException {
        Path file = scenario();
        Path link = Files.createSymbolicLink(folder.resolve("link"), Path.of("a.xml"));
        Path hard = Files.createLink(folder.resolve("hard"), file);
        for (Path output : List.of(link, hard)) {
            assertTrue(refusal("run", file, "--until", "1", option, output).contains("is an input or another output"));
        }
        assertEquals(Files.readString(SCENARIO), Files.readString(file));
    }

    /** The user has named only the page. A series of scenarios is named as the replays are. */
    @ParameterizedTest
    @CsvSource({"room.csv, controller;seed", "room-1.xml, <scenario/>", "room-2.xml, notes"})
    void compareRefusesToReplaceFilesThatNoComparisonHasWritten(String name, String content) throws Exception {
        Path other = Files.writeString(folder.resolve(name), content);
        String message = refusal(
                "compare",
                scenario(),
                "--controller=none",
                "--controller=wall-follower",
                "--until=1",
                "--out=" + folder.resolve("room.html"));
        assertEquals(
                "faultline: " + other + ": compare would replace or delete this file, which no comparison has written;"
                        + " use another name in --out\n",
                message);
        assertEquals(content, Files.readString(other));
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(2, files.count(), "the scenario and the other file");
        }
    }

    @Test
    void twoOutputsThatAreOneFileByALinkAreRefused() throws IOException {
        Path link = Files.createSymbolicLink(folder.resolve("link"), Path.of("new.csv"));
        String message = refusal("run", SCENARIO, "--trace", folder.resolve("new.csv"), "--journal", link);
        assertTrue(message.contains("is an input or another output"), message);
    }

    /** The run would wait for a program that reads the pipe twice. */
    @Test
    @Timeout(60)
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "there are no named pipes")
    void twoOutputsThatAreOnePipeAreRefused() throws Exception {
        Path pipe = folder.resolve("pipe");
        assertEquals(0, new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor());
        String message = refusal("run", SCENARIO, "--until", "1", "--trace", pipe, "--journal", pipe);
        assertTrue(message.contains("pipe\" is an input or another output; expected another file"), message);
    }

    @ParameterizedTest
    @ValueSource(strings = {"--trace", "--image", "--journal", "--film"})
    void anOutputThatIsTheScriptOfTheControllerIsRefused(String option) throws IOException {
        Path script = Files.writeString(folder.resolve("my.sh"), "exit 5\n");
        Path link = Files.createSymbolicLink(folder.resolve("link"), script);
        String message = refusal("run", SCENARIO, "--controller", "sh " + script, option, link);
        assertTrue(message.contains("is an input or another output"), message);
        assertEquals("exit 5\n", Files.readString(script));
    }

    @Test
    void aComparisonThatWouldReplaceAScriptOrItsScenarioIsRefused() throws IOException {
        Path script = Files.writeString(folder.resolve("my.sh"), "exit 5\n");
        Path out = Files.createSymbolicLink(folder.resolve("page-2.xml"), script);
        String[] controllers = {"--controller", "none", "--controller", "sh " + script};
        Path page = folder.resolve("page.html");
        String message = refusal(
                "compare", SCENARIO, "--out", page, controllers[0], controllers[1], controllers[2], controllers[3]);
        assertTrue(message.contains(out + "\" is an input or another output"), message);
        assertEquals("exit 5\n", Files.readString(script));
        assertTrue(Files.notExists(page));
    }

    @Test
    void aTableOfAComparisonThatCannotBeWrittenIsReportedBeforeTheRuns() throws IOException {
        Path ran = folder.resolve("ran");
        Files.createDirectory(folder.resolve("page.csv"));
        Path page = folder.resolve("page.html");
        String child = "sh -c 'touch " + ran + "; exit 5'";
        String message = refusal("compare", SCENARIO, "--out", page, "--controller", "none", "--controller", child);
        assertTrue(message.contains("page.csv: this is a folder"), message);
        assertTrue(Files.notExists(ran));
        assertTrue(Files.notExists(page));
    }

    @Test
    void theRootIsNoPage() {
        String message =
                refusal("compare", SCENARIO, "--out", "/", "--controller", "none", "--controller", "wall-follower");
        assertTrue(message.contains("\"/\" is a folder; expected a file"), message);
    }

    @Test
    void anImportThatWouldReplaceItsMapIsRefused() throws IOException {
        Path map = folder.resolve("map.png");
        ImageIO.write(new BufferedImage(9, 9, BufferedImage.TYPE_BYTE_GRAY), "png", map.toFile());
        byte[] before = Files.readAllBytes(map);
        Path link = Files.createSymbolicLink(folder.resolve("out.xml"), map);
        refusal("import", map, "--resolution", "0.1", "--out", link);
        Path yaml = Files.writeString(
                folder.resolve("map.yaml"),
                "image: map.png\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 1\noccupied_thresh: 0.65\n"
                        + "free_thresh: 0.2\n");
        assertTrue(refusal("import", yaml, "--out", link)
                .contains("is an input or another output; expected another file"));
        assertEquals(before.length, Files.size(map));
    }

    /** Both show the path of the robot, which is recorded only if one of them is wanted. */
    @Test
    void aPictureAndAFilmAreTheSameTogetherAsAlone() throws IOException {
        List<Path> outputs = new ArrayList<>();
        for (String name : List.of("alone.svg", "both.svg", "alone.gif", "both.gif")) {
            outputs.add(folder.resolve(name));
        }
        run("--image", outputs.get(0));
        run("--image", outputs.get(1), "--film", outputs.get(3));
        run("--film", outputs.get(2));
        assertEquals(-1, Files.mismatch(outputs.get(0), outputs.get(1)), "the picture");
        assertEquals(-1, Files.mismatch(outputs.get(2), outputs.get(3)), "the film");
    }

    @Test
    void aRunThatBreaksLeavesNoFile() throws IOException {
        PrintStream none = new PrintStream(new ByteArrayOutputStream(), true, StandardCharsets.UTF_8);
        String[] arguments = {
            "run",
            SCENARIO.toString(),
            "--trace",
            folder + "/a.csv",
            "--image",
            folder + "/a.svg",
            "--controller",
            "sh -c 'read hello; exit 5'"
        };
        assertEquals(ExitCode.RUN_FAILED, new CommandLine(new CommandOutput(none, none)).run(arguments));
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(List.of(), files.toList());
        }
    }

    private static void run(Object... options) {
        PrintStream none = new PrintStream(new ByteArrayOutputStream(), true, StandardCharsets.UTF_8);
        String[] arguments = Stream.concat(
                        Stream.of("run", "scenarios/beside-a-wall.xml", "--until", "6"), Stream.of(options))
                .map(Object::toString)
                .toArray(String[]::new);
        int code = new CommandLine(new CommandOutput(none, none)).run(arguments);
        assertTrue(code == ExitCode.SUCCESS || code == ExitCode.EXPECTATION_FAILED, "exit code " + code);
    }

    private Path campaign() throws IOException {
        Files.writeString(folder.resolve("room.xml"), SamplePlan.ROOM);
        return Files.writeString(
                folder.resolve("plan.xml"),
                SamplePlan.text("", "<worlds><scenario file=\"room.xml\"/></worlds><seeds count=\"2\"/>"));
    }

    @Test
    void aCampaignThatWouldReplaceItsPlanIsRefused() throws IOException {
        Path plan = campaign();
        Path out = Files.createDirectory(folder.resolve("out"));
        Files.createSymbolicLink(out.resolve("runs.csv"), folder.resolve("room.xml"));
        String message = refusal("campaign", plan, "--out", out, "--resume");
        assertTrue(message.contains("runs.csv"), message);
        assertEquals(SamplePlan.ROOM, Files.readString(folder.resolve("room.xml")));
        Files.delete(out.resolve("runs.csv"));
        Files.createSymbolicLink(out.resolve("runs.csv"), Path.of("timing.csv"));
        assertTrue(refusal("campaign", plan, "--out", out).contains("timing.csv"));
    }

    @Test
    void aReportOrAMergeThatWouldReplaceATableIsRefused() throws IOException {
        Path part = folder.resolve("part");
        PrintStream none = new PrintStream(new ByteArrayOutputStream());
        String[] arguments = {"campaign", campaign().toString(), "--out", part.toString(), "--jobs", "1"};
        assertEquals(0, new CommandLine(new CommandOutput(none, none)).run(arguments));
        String table = Files.readString(part.resolve("runs.csv"));
        assertTrue(refusal("report", part, "--out", part.resolve("plan/../runs.csv"))
                .contains("is an input or another output; expected another file"));
        Path merged = Files.createDirectory(folder.resolve("merged"));
        Files.createSymbolicLink(merged.resolve("timing.csv"), part.resolve("runs.csv"));
        refusal("merge", part, "--out", merged);
        assertEquals(table, Files.readString(part.resolve("runs.csv")));
    }

    @ParameterizedTest
    @ValueSource(strings = {"--trace", "--image", "--journal"})
    void aFullDiskIsOneSentenceWithTheNameOfTheFile(String option) {
        assumeTrue(Files.exists(Path.of("/dev/full")));
        assertEquals(
                "faultline: /dev/full: the file cannot be written completely, because the disk is full\n",
                refusal("run", SCENARIO, option, "/dev/full"));
    }

    @Test
    void aTraceThatGoesToADeviceHasNoHeaderFileBesideIt() throws IOException {
        Path device = Path.of("/dev/null");
        assumeTrue(Files.exists(device));
        Path link = Files.createSymbolicLink(folder.resolve("t.csv"), device);
        String[] args = {"run", SCENARIO.toString(), "--until", "1", "--trace-format", "2", "--trace", link.toString()};
        PrintStream sink = new PrintStream(new ByteArrayOutputStream(), true, StandardCharsets.UTF_8);
        int code = new CommandLine(new CommandOutput(sink, sink)).run(args);
        assertEquals(1, code, "the scenario expects more than happens in one second");
        assertFalse(Files.exists(folder.resolve("t.csv.json")));
    }

    @Test
    void aTableOfACampaignThatIsADeviceIsRefusedBeforeItIsRead() throws IOException {
        assumeTrue(Files.exists(Path.of("/dev/full")));
        Path out = Files.createDirectory(folder.resolve("out"));
        Path table = Files.createSymbolicLink(out.resolve("timing.csv"), Path.of("/dev/full"));
        assertEquals(
                "faultline: " + table + ": this is not a regular file; expected a table\n",
                refusal("campaign", campaign(), "--out", out, "--jobs", "1"));
        Files.delete(table);
    }

    @Test
    void hostileNamesDoNotReachTheTerminalAsTheyAre() {
        String message = refusal("run", folder.resolve("a\u001b[31m\n\u202eb\u009b.xml"));
        assertTrue(message.endsWith("a [31m  b .xml: there is no such file\n"), message);
    }

    private Process start(List<String> arguments, Path output, String... options) throws Exception {
        List<String> command = JavaProcess.program();
        command.addAll(1, List.of(options));
        command.addAll(arguments);
        return new ProcessBuilder(command).redirectOutput(output.toFile()).start();
    }

    /** In the second locale the JDK formats numbers with other digits. */
    @ParameterizedTest
    @CsvSource({"en,GB", "ar,EG"})
    void aTraceOnStandardOutputIsWrittenToItAndDoesNotReplaceIt(String language, String country) throws Exception {
        assumeTrue(Files.exists(Path.of("/dev/stdout")));
        Path output = Files.writeString(folder.resolve("out.txt"), "");
        Object inode = Files.getAttribute(output, "unix:ino");
        Process process = start(
                List.of("run", SCENARIO.toString(), "--until", "8.95", "--trace", "/dev/stdout"),
                output,
                "-Duser.language=" + language,
                "-Duser.country=" + country);
        assertTrue(process.waitFor(60, TimeUnit.SECONDS));
        assertEquals(inode, Files.getAttribute(output, "unix:ino"));
        List<String> lines = Files.readAllLines(output);
        assertTrue(lines.get(0).startsWith("tick,t,x,y"), lines.get(0));
        assertTrue(lines.get(1).startsWith("0,0.0,"), lines.get(1));
        assertTrue(lines.contains("ticks: 895"), "the summary follows the trace");
    }

    @Test
    void aRunThatIsTerminatedLeavesTheOldFilesAndNothingElse() throws Exception {
        Path trace = Files.writeString(folder.resolve("trace.csv"), "old");
        Path output = folder.resolve("out.txt");
        Process process = start(
                List.of("run", "scenarios/office.xml", "--until", "10000000", "--trace", trace.toString()), output);
        boolean ended = false;
        while (!ended && largest() < 100_000) {
            ended = process.waitFor(5, TimeUnit.MILLISECONDS);
        }
        process.destroy();
        assertTrue(process.waitFor(60, TimeUnit.SECONDS));
        assertEquals(143, process.exitValue());
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(List.of(output, trace), files.sorted().toList());
        }
        assertEquals("old", Files.readString(trace));
    }

    private long largest() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.mapToLong(file -> file.toFile().length()).max().orElse(0);
        }
    }

    @Test
    void anIdThatASpreadsheetWouldRunIsWrittenAsText() throws IOException {
        String id = "=HYPERLINK(x)";
        Path file = Files.writeString(
                folder.resolve("a.xml"),
                "<scenario xmlns=\"urn:faultline:scenario:1\" duration=\"0\"><world width=\"6\" height=\"4\"/>"
                        + "<robot x=\"1\" y=\"1\" defaultSensors=\"false\"><sensor id=\"" + id
                        + "\" x=\"0\" y=\"0\" bearing=\"0\"/></robot></scenario>");
        Path trace = folder.resolve("trace.csv");
        PrintStream none = new PrintStream(new ByteArrayOutputStream());
        String[] arguments = {"run", file.toString(), "--trace", trace.toString()};
        assertEquals(0, new CommandLine(new CommandOutput(none, none)).run(arguments));
        String header = Files.readAllLines(trace).get(0);
        assertTrue(header.endsWith(",collided,'=HYPERLINK(x).true,'=HYPERLINK(x).reading"), header);
    }

    @Test
    void theOutputsAreKeptWhenTheResultCannotBeComputed() throws Exception {
        Path trace = folder.resolve("trace.csv");
        Path journal = folder.resolve("journal.xml");
        RunOptions options = RunOptions.parse(List.of(
                SCENARIO.toString(), "--until", "1", "--trace", trace.toString(), "--journal", journal.toString()));
        Scenario scenario = options.applyTo(Scenario.load(SCENARIO));
        try (RunOutputs outputs = new RunOutputs(options)) {
            assertThrows(
                    HeadlessRun.ResultFailedException.class,
                    () -> RunCommand.keepOutputs(
                            scenario,
                            outputs,
                            () -> {
                                HeadlessRun.run(scenario.setup(), options.mode(), outputs.observers());
                                throw new HeadlessRun.ResultFailedException(new StackOverflowError());
                            },
                            sentence -> {}));
        }
        assertEquals(102, Files.readAllLines(trace).size());
        assertEquals(scenario.name(), Scenario.load(journal).name());
    }

    @Test
    void theOtherOutputsAreKeptWhenTheJournalCannotBeSaved() throws Exception {
        Path trace = folder.resolve("trace.csv");
        Path journal = folder.resolve("journal.xml");
        RunOptions options = RunOptions.parse(List.of(
                SCENARIO.toString(), "--until", "1", "--trace", trace.toString(), "--journal", journal.toString()));
        Scenario scenario = options.applyTo(Scenario.load(SCENARIO));
        String text = "x".repeat((int) ScenarioLimits.MAX_BYTES);
        Scenario large = new Scenario("large", text, false, scenario.setup(), scenario.expectation());
        try (RunOutputs outputs = new RunOutputs(options)) {
            HeadlessRun.run(scenario.setup(), options.mode(), outputs.observers());
            assertEquals(
                    "faultline: " + journal
                            + ": the scenario cannot be saved: the file has 16.1 MiB; expected at most 16 MiB",
                    outputs.finish(large).orElseThrow());
        }
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(List.of(trace), files.toList());
        }
        assertEquals(102, Files.readAllLines(trace).size());
    }

    @Test
    void aJournalThatCannotBeSavedIsReportedIfTheResultCannotBeComputedEither() throws Exception {
        Path journal = folder.resolve("journal.xml");
        RunOptions options =
                RunOptions.parse(List.of(SCENARIO.toString(), "--until", "1", "--journal", journal.toString()));
        Scenario scenario = options.applyTo(Scenario.load(SCENARIO));
        String text = "x".repeat((int) ScenarioLimits.MAX_BYTES);
        Scenario large = new Scenario("large", text, false, scenario.setup(), scenario.expectation());
        List<String> errors = new ArrayList<>();
        try (RunOutputs outputs = new RunOutputs(options)) {
            assertThrows(
                    HeadlessRun.ResultFailedException.class,
                    () -> RunCommand.keepOutputs(
                            large,
                            outputs,
                            () -> {
                                HeadlessRun.run(scenario.setup(), options.mode(), outputs.observers());
                                throw new HeadlessRun.ResultFailedException(new StackOverflowError());
                            },
                            errors::add));
        }
        assertEquals(
                List.of("faultline: " + journal
                        + ": the scenario cannot be saved: the file has 16.1 MiB; expected at most 16 MiB"),
                errors);
    }

    /** Writes a scenario of 6 MB whose journal has 18 MB, because each character of the id becomes four. */
    static Path scenarioWithTooLongAJournal(Path folder) throws IOException {
        String id = ">".repeat(100);
        return Files.writeString(
                folder.resolve("long.xml"),
                "<scenario xmlns='urn:faultline:scenario:1' duration='0.1'><world width='6' height='4'/>"
                        + "<robot x='1' y='1' defaultSensors='false'><sensor id='" + id
                        + "' x='0' y='0' bearing='0'/></robot><timeline>"
                        + ("<fault at='0' sensor='" + id + "' kind='off'/>").repeat(43_000)
                        + "</timeline><expect collision='true'/></scenario>");
    }

    @Test
    void aJournalThatCannotBeSavedIsReportedAfterTheExpectationsAndAnOldOneIsDeleted() throws IOException {
        Path file = scenarioWithTooLongAJournal(folder);
        Path trace = Files.writeString(folder.resolve("trace.csv"), "old");
        Path journal = Files.writeString(folder.resolve("journal.xml"), "old");
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        int code = new CommandLine(new CommandOutput(
                        new PrintStream(out, true, StandardCharsets.UTF_8),
                        new PrintStream(err, true, StandardCharsets.UTF_8)))
                .run("run", file.toString(), "--trace", trace.toString(), "--journal", journal.toString());
        assertEquals(2, code);
        assertTrue(out.toString(StandardCharsets.UTF_8).endsWith("expectations: failed\n"));
        assertEquals(
                List.of(
                        "expected a collision, but there was none",
                        "faultline: " + journal
                                + ": the scenario cannot be saved: the file has 18.1 MiB; expected at most 16 MiB"),
                err.toString(StandardCharsets.UTF_8).lines().toList());
        assertEquals(12, Files.readAllLines(trace).size());
        assertFalse(Files.exists(journal), "the journal would seem to be of this run");
    }

    @Test
    void aRunThatBreaksLeavesTheOldFiles() throws Exception {
        Path trace = Files.writeString(folder.resolve("trace.csv"), "old");
        RunOptions options = RunOptions.parse(List.of(SCENARIO.toString(), "--trace", trace.toString()));
        Scenario scenario = options.applyTo(Scenario.load(SCENARIO));
        try (RunOutputs outputs = new RunOutputs(options)) {
            assertThrows(
                    RunFailedException.class,
                    () -> RunCommand.keepOutputs(
                            scenario,
                            outputs,
                            () -> {
                                HeadlessRun.run(scenario.setup(), options.mode(), outputs.observers());
                                throw new RunFailedException("no wheels", null);
                            },
                            sentence -> {}));
        }
        assertEquals("old", Files.readString(trace));
    }
}
