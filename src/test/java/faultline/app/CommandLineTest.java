package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import faultline.io.JsonParser;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.w3c.dom.Element;

/** Runs the command line and checks exit codes, output and error messages. */
class CommandLineTest {

    private static final String COLLIDING_SCENARIO = "scenarios/struck-by-a-visitor.xml";

    @TempDir
    private Path folder;

    /** The result of a command. */
    private record CommandResult(int code, String out, String err) {

        String value(String key) {
            return out.lines()
                    .filter(line -> line.startsWith(key + ": "))
                    .findFirst()
                    .orElseThrow()
                    .substring(key.length() + 2);
        }
    }

    private static CommandResult command(String... args) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        int code = new CommandLine(new CommandOutput(stream(out), stream(err))).run(args);
        return new CommandResult(code, out.toString(StandardCharsets.UTF_8), err.toString(StandardCharsets.UTF_8));
    }

    private static PrintStream stream(OutputStream out) {
        return new PrintStream(out, true, StandardCharsets.UTF_8);
    }

    @Test
    void anInternalErrorIsNamedByItsFirstCause() {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        PrintStream out = new PrintStream(OutputStream.nullOutputStream(), true, StandardCharsets.UTF_8) {
            @Override
            public void println(String line) {
                throw new IllegalStateException(new UnsupportedOperationException("no fonts here"));
            }
        };
        assertEquals(3, new CommandLine(new CommandOutput(out, stream(err))).run("--version"));
        assertEquals(
                "faultline: internal error: java.lang.UnsupportedOperationException: no fonts here",
                err.toString(StandardCharsets.UTF_8).strip());
    }

    @Test
    void runPrintsTheSummaryAsKeysAndValues() {
        CommandResult run = command("run", COLLIDING_SCENARIO);
        assertEquals(0, run.code);
        assertEquals("", run.err);
        assertEquals(
                List.of(
                        "ticks",
                        "simulated_s",
                        "real_time_factor",
                        "state",
                        "states",
                        "collision",
                        "collided_with",
                        "coverage",
                        "distance_rms_m",
                        "follow_rms_m",
                        "trajectory_hash",
                        "seed",
                        "rung",
                        "rung_changes",
                        "health_changes",
                        "expectations"),
                run.out.lines().map(line -> line.split(": ")[0]).toList());
        assertEquals("2000", run.value("ticks"));
        assertEquals("20", run.value("simulated_s"));
        assertEquals("NONE", run.value("state"));
        assertTrue(
                run.value("collision").matches("2\\.125000000,2\\.100000000 at 8\\.9166666\\d{2}"),
                run.value("collision"));
        assertEquals("visitor", run.value("collided_with"));
        assertTrue(run.value("trajectory_hash").matches("[0-9a-f]{16}"), run.value("trajectory_hash"));
        assertEquals("held", run.value("expectations"));
    }

    @Test
    void anObstacleThatIsCalledNoneIsToldFromNoObstacle() throws IOException {
        String text = Files.readString(Path.of(COLLIDING_SCENARIO)).replace("\"visitor\"", "\"none\"");
        Path file = Files.writeString(folder.resolve("none.xml"), text);
        CommandResult run = command("run", file.toString());
        assertEquals("\"none\"", run.value("collided_with"));
        assertEquals("none", command("run", file.toString(), "--until", "1").value("collided_with"));
    }

    @Test
    void aValueMayContainAnEqualsSignAndTheLargestWholeNumberIsAllowed() {
        Path trace = folder.resolve("a=b.csv");
        CommandResult run =
                command("run", COLLIDING_SCENARIO, "--until=0", "--trace=" + trace, "--seed=" + Long.MAX_VALUE);
        assertEquals("9223372036854775807", run.value("seed"), run.err);
        assertTrue(Files.exists(trace));
    }

    @ParameterizedTest
    @ValueSource(strings = {"0.001", "1000000"})
    void aPaceMayBeALimit(String pace) {
        CommandResult run = command("run", COLLIDING_SCENARIO, "--until", "0", "--pace", pace);
        assertEquals("0", run.value("ticks"), run.err);
    }

    @ParameterizedTest
    @ValueSource(strings = {"none", "0.5", "10000000"})
    void thePatienceMayBeALimitOrNone(String patience) {
        CommandResult run =
                command("run", COLLIDING_SCENARIO, "--until", "0", "--controller", "none", "--patience", patience);
        assertEquals("0", run.value("ticks"), run.err);
    }

    @Test
    void untilAndSeedTakeThePlaceOfTheFiles() {
        CommandResult run = command("run", COLLIDING_SCENARIO, "--until", "2.5", "--seed=-7");
        assertEquals("250", run.value("ticks"));
        assertEquals("-7", run.value("seed"));
        assertEquals("none", run.value("collision"));
    }

    @Test
    void anExpectationThatFailsIsExitCodeOneAndASentence() {
        CommandResult run = command("run", COLLIDING_SCENARIO, "--until", "1");
        assertEquals(1, run.code);
        assertEquals("failed", run.value("expectations"));
        assertEquals("expected a collision, but there was none\n", run.err);
    }

    @Test
    void theTrajectoryIsTheSameWhereverTheControllerRuns() {
        String file = "scenarios/inner-corner-90.xml";
        assertEquals(
                command("run", file, "--until", "20").value("trajectory_hash"),
                command("run", file, "--until", "20", "--threads", "controller").value("trajectory_hash"));
    }

    @Test
    void everyOutputIsWrittenAndTheJournalReplaysTheRun() throws IOException {
        Path trace = folder.resolve("trace.csv");
        Path image = folder.resolve("image.png");
        Path journal = folder.resolve("journal.xml");
        CommandResult run = command(
                "run",
                COLLIDING_SCENARIO,
                "--until",
                "12",
                "--seed",
                "5",
                "--trace",
                trace.toString(),
                "--image",
                image.toString(),
                "--journal",
                journal.toString());
        assertEquals(0, run.code, run.err);
        List<String> rows = Files.readAllLines(trace);
        assertTrue(
                rows.get(0)
                        .startsWith("tick,t,x,y,heading_deg,v,omega,left_v,right_v,state,"
                                + "collided,front.true,front.reading,"),
                rows.get(0));
        assertEquals(1 + 1 + 1200, rows.size());
        assertEquals(1200, ImageIO.read(image.toFile()).getWidth());
        CommandResult replay = command("run", journal.toString());
        assertEquals(run.value("trajectory_hash"), replay.value("trajectory_hash"));
        assertEquals("5", replay.value("seed"));
        assertEquals(List.of(image, journal, trace), filesInFolder());
    }

    @ParameterizedTest
    @ValueSource(strings = {"image.svg", "IMAGE.SVG"})
    void anImageIsADrawingIfItsFileIsNamedSo(String name) throws Exception {
        Path image = folder.resolve(name);
        assertEquals(0, command("run", COLLIDING_SCENARIO, "--until", "12", "--image", "" + image).code);
        Element drawing = DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(image.toFile())
                .getDocumentElement();
        assertEquals("svg", drawing.getTagName());
        assertEquals("1200", drawing.getAttribute("width"));
    }

    @Test
    void anUnwritableOutputIsReportedBeforeTheRunAndLeavesNoFile() throws IOException {
        Path trace = folder.resolve("trace.csv");
        String image = folder.resolve("none").resolve("image.png").toString();
        assertEquals(
                new CommandResult(2, "", "faultline: " + image + ": its folder does not exist\n"),
                command("run", COLLIDING_SCENARIO, "--trace", trace.toString(), "--image", image));
        assertEquals(List.of(), filesInFolder());
    }

    private List<Path> filesInFolder() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.sorted().toList();
        }
    }

    @Test
    void checkReportsARecordInWhichEveryRunBreaks() throws IOException {
        String room = "<scenario xmlns='urn:faultline:scenario:1' duration='%s'><world width='3' height='3'/>"
                + "<robot x='1.2' y='1'/><controller type='recorded' ticks='%s'/></scenario>";
        String file = folder.resolve("record.xml").toString();
        Files.writeString(Path.of(file), room.formatted("1", "0"));
        assertEquals(
                new CommandResult(
                        2,
                        "",
                        file + ": ticks of <controller> is \"0\"; expected at least 1, because a run breaks where the"
                                + " record ends\n"),
                command("check", file));
        // What can be run is good: another controller, a record without movement, and a run that has just begun.
        assertEquals(0, command("run", file, "--controller", "none").code);
        for (String[] good : List.of(new String[] {"1", "100"}, new String[] {"0", "0"})) {
            Files.writeString(Path.of(file), room.formatted((Object[]) good));
            assertEquals(new CommandResult(0, file + ": good\n", ""), command("check", file));
            assertEquals(0, command("run", file).code);
        }
    }

    @Test
    void checkReportsANameThatNoFileCanHaveAndTheOtherFiles() {
        CommandResult checked = command("check", "", "gone.xml", COLLIDING_SCENARIO);
        assertEquals(
                new CommandResult(
                        2,
                        COLLIDING_SCENARIO + ": good\n",
                        "\"\" cannot be the name of a file\ngone.xml: there is no such file\n"),
                checked);
    }

    @Test
    void checkReportsValidAndInvalidFiles() throws IOException {
        Path bad = Files.writeString(folder.resolve("bad.xml"), "<scenario/>");
        assertEquals(
                new CommandResult(
                        2,
                        COLLIDING_SCENARIO + ": good\n",
                        bad + ":1:12: the root element is <scenario xmlns=\"\">; expected <scenario "
                                + "xmlns=\"urn:faultline:scenario:1\">\n"),
                command("check", bad.toString(), COLLIDING_SCENARIO));
        assertEquals(0, command("check", COLLIDING_SCENARIO).code);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            textBlock =
                    """
            rnu x.xml                       | there is no command "rnu"; expected run, compare, check, campaign, merge, report, figures, serve, controller, import, --help, --version, --window, --startup-time or a scenario file; did you mean "run"?
            --help rnu                      | --help takes the name of one command, not "rnu"; did you mean "run"?
            --help run check                | --help takes the name of one command, not "run check"
            help rnu                        | help takes the name of one command, not "rnu"; did you mean "run"?
            -h run check                    | -h takes the name of one command, not "run check"
            run a.xml --trace new/          | --trace is "new/"; expected the name of a file, which does not end with a slash
            import a.png --out -            | --out is "-"; expected the name of a file; standard output is /dev/stdout, and a file named - is ./-
            import a.png --out new/         | --out is "new/"; expected the name of a file, which does not end with a slash
            --version 0.1.0                 | --version takes nothing, not "0.1.0"
            --controller none x.xml         | there is no command "--controller"; expected run, compare, check, campaign, merge, report, figures, serve, controller, import, --help, --version, --window, --startup-time or a scenario file; options come last
            --hepl                          | there is no command "--hepl"; expected run, compare, check, campaign, merge, report, figures, serve, controller, import, --help, --version, --window, --startup-time or a scenario file; did you mean "--help"?
            a.xml b.xml                     | the window takes one scenario file, not also "b.xml"
            --window a.xml b.xml            | the window takes one scenario file, not also "b.xml"
            none.faultline b.xml            | the window takes one scenario file, not also "b.xml"
            run                             | run takes one scenario file, not none
            run a.xml b.xml                 | run takes one scenario file, not 2
            check                           | check takes one or more scenario files or plans, not none
            check --all a.xml               | there is no option "--all" here; expected --jar
            run a.xml --sed 1               | there is no option "--sed" here; expected --until, --seed, --threads, --trace, --trace-format, --image, --journal, --film, --pace, --controller, --jar, --patience, --truth, --json; did you mean "--seed"?
            run a.xml -x                    | there is no option "-x" here; expected --until, --seed, --threads, --trace, --trace-format, --image, --journal, --film, --pace, --controller, --jar, --patience, --truth, --json
            run a.xml --pace 0              | --pace is "0"; expected a multiple of real time from 0.001 to 1000000
            run a.xml --pace 1000000.1      | --pace is "1000000.1"; expected a multiple of real time from 0.001 to 1000000
            run a.xml --controller none --patience 0 | --patience is "0"; expected none or a number of seconds above 0, up to 10000000
            run a.xml --controller none --patience 10000000.1 | --patience is "10000000.1"; expected none or a number of seconds above 0, up to 10000000
            run a.xml --truth --controller none | --truth needs --controller COMMAND
            a.xml --controller=             | --controller is ""; expected the name of a controller or a command
            a.xml --ghost-controller=       | --ghost-controller is ""; expected the name of a controller or a command
            run a.xml --controller=         | --controller is ""; expected the name of a controller or a command
            compare a.xml --controller none --controller= --out b | --controller is ""; expected the name of a controller or a command
            run a.xml --pace 1e-320         | --pace is "1e-320"; expected a multiple of real time from 0.001 to 1000000
            run a.xml --jar pom.xml         | --jar is "pom.xml", which is not a jar
            run a.xml --jar none.jar        | --jar is "none.jar", and there is no such file
            run a.xml --jar .               | --jar is ".", which is not a jar
            run a.xml --seed                | --seed needs a value
            run a.xml --film --until 5      | --film needs a value, and "--until" is an option
            run a.xml --seed +3 --pace 0    | --pace is "0"; expected a multiple of real time from 0.001 to 1000000
            import a.png --out b --min-cells +3 --resolution 0 | --resolution is "0"; expected a number of metres from 0.000001 to 100000
            compare a.xml --controller none --controller x --out b --seeds +10001 | --seeds is "+10001"; expected a whole number from 1 to 10000
            run a.xml --seed 1 --seed 2     | --seed is given twice
            run a.xml --seed 1.5            | --seed is "1.5"; expected a whole number from -9223372036854775808 to 9223372036854775807
            run a.xml --seed ９             | --seed is "９"; expected a whole number from -9223372036854775808 to 9223372036854775807
            run a.xml --until -1            | --until is "-1"; expected a number from 0 to 10000000 seconds
            run a.xml --until NaN           | --until is "NaN"; expected a number from 0 to 10000000 seconds
            run a.xml --until 1e999         | --until is "1e999"; expected a number from 0 to 10000000 seconds
            run a.xml --threads controler   | --threads is "controler"; expected controller or none; did you mean "controller"?
            run a.xml --trace b --image ./b | the output "./b" is an input or another output; expected another file
            run a.xml --journal a.xml       | the output "a.xml" is an input or another output; expected another file
            run a.xml --controller cat --patience 1e-999 | --patience is "1e-999"; expected none or a number of seconds above 0, up to 10000000
            run a.xml --trace-format 2      | --trace-format needs --trace OUT.csv
            run a.xml --threads controller --controller cat | --threads is "controller"; expected none, because the child process of --controller runs by itself
            run a.xml --trace=              | "" cannot be the name of a file
            campaign a.xml --resum          | there is no option "--resum" here; expected --out, --jobs, --shard, --jar, --resume; did you mean "--resume"?
            campaign a.xml --resume=yes     | --resume takes no value
            compare a.xml --controler none  | there is no option "--controler" here; expected --controller, --seeds, --out, --until, --jar, --patience, --truth, --open; did you mean "--controller"?
            import a.png --out b --smooth 1e9 | --smooth is "1e9"; expected a number of cells from 0 to 100000
            import a.png --out b --min-cells -1 | --min-cells is "-1"; expected a whole number from 0 to 999999999
            """)
    void badUsageIsExitCodeTwoAndOneLine(String arguments, String problem) {
        assertEquals(
                new CommandResult(2, "", "faultline: " + problem + " (see faultline --help)\n"),
                command(arguments.split(" ")));
    }

    @Test
    void whoOpensAControllerAsAScenarioLearnsTheOptionsForIt(@TempDir Path programs) throws Exception {
        Path program = Files.writeString(programs.resolve("robot.py"), "import faultline\n");
        String hint = "\nfaultline: a program drives the robot by run SCENARIO --controller COMMAND, a jar by --jar\n";
        CommandResult refused = command("run", program.toString());
        assertEquals(2, refused.code());
        assertTrue(refused.err().endsWith(hint), refused.err());
        Path room = Files.writeString(programs.resolve("robot.xml"), "import faultline\n");
        assertTrue(!command("run", room.toString()).err().contains("--controller"));
    }

    @Test
    void anExistingFileThatBeginsLikeAnOptionHasAnotherName() throws Exception {
        Path file = Files.createTempFile(Path.of(""), "-room", ".xml");
        try {
            String problem = command("check", file.toString()).err();
            assertTrue(problem.contains("; the file of this name is written ./" + file + " (see"), problem);
        } finally {
            Files.delete(file);
        }
    }

    /** The virtual machine puts this character in the place of bytes that are not in the encoding of the locale. */
    @Test
    void aNameWithAReplacementCharacterIsOnlyThatOfAFileThatExists(@TempDir Path names) throws Exception {
        String text = names.resolve("\uFFFD.xml").toString();
        CommandResult refused = command("import", "a.png", "--out", text);
        assertEquals(2, refused.code());
        assertTrue(
                refused.err().contains("\uFFFD.xml\" cannot be the name of a file in the encoding of this locale, "),
                refused.err());
        if (System.getProperty("sun.jnu.encoding").equals("UTF-8")) {
            Files.copy(Path.of("scenarios/yard.xml"), Path.of(text));
            assertEquals(0, command("check", text).code());
        }
    }

    @Test
    @EnabledOnOs(value = OS.LINUX, disabledReason = "other systems have one encoding for the names of files")
    void anEncodingThatLacksALetterOfAFileIsNamed(@TempDir Path names) throws Exception {
        List<String> command =
                new ArrayList<>(List.of("sh", "-c", "exec \"$@\" \"$(printf 'm\\303\\263j.xml')\"", "sh"));
        command.addAll(
                JavaProcess.builder("faultline.app.Main", List.of("check")).command());
        assertNamesEncoding(new ProcessBuilder(command));
        Path plan = Files.writeString(
                names.resolve("plan.xml"),
                "<campaign xmlns=\"urn:faultline:campaign:1\">"
                        + "<worlds><scenario file=\"m\u00f3j.xml\"/></worlds></campaign>");
        assertNamesEncoding(JavaProcess.builder("faultline.app.Main", List.of("check", plan.toString())));
    }

    @Test
    @EnabledOnOs(value = OS.LINUX, disabledReason = "other systems have one encoding for the names of files")
    void anUnknownOptionIsReportedAlsoIfItCannotBeTheNameOfAFile() throws Exception {
        List<String> command =
                new ArrayList<>(List.of("sh", "-c", "exec \"$@\" \"$(printf -- '--gr\\303\\266e')\"", "sh"));
        command.addAll(JavaProcess.builder("faultline.app.Main", List.of("check", "a.xml"))
                .command());
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().put("LC_ALL", "C");
        String output = JavaProcess.output(builder.start());
        assertTrue(output.contains("there is no option"), output);
    }

    private static void assertNamesEncoding(ProcessBuilder builder) throws Exception {
        builder.environment().put("LC_ALL", "C");
        String output = JavaProcess.output(builder.redirectErrorStream(true).start());
        assertTrue(output.contains("cannot be the name of a file in the encoding of this locale, "), output);
        assertTrue(output.contains("LC_ALL=C.UTF-8"), output);
    }

    @Test
    void aLackOfMemoryIsOneLine() throws Exception {
        StringBuilder text = new StringBuilder("<scenario xmlns=\"urn:faultline:scenario:1\">");
        text.append("<world width=\"9\" height=\"9\"><wall id=\"wall\" x=\"0\" y=\"0\" points=\"");
        for (int i = 0; i < 90_000; i++) {
            text.append(i).append(",0.123456789 ");
        }
        text.append("\"/></world><robot x=\"1\" y=\"1\"/></scenario>");
        Path file = folder.resolve("long.xml");
        Files.writeString(file, text);
        Process process = JavaProcess.startWithHeap("12m", "faultline.app.Main", List.of("run", file.toString()));
        assertEquals("faultline: there is not enough memory\n", JavaProcess.output(process));
        assertEquals(3, process.waitFor());
    }

    @Test
    void aScenarioForAControllerFromOutsideHasNoneToActAs() throws Exception {
        Path file = folder.resolve("extern.xml");
        Files.writeString(
                file,
                Files.readString(Path.of(COLLIDING_SCENARIO))
                        .replaceFirst("<controller[^>]*>", "<controller type=\"extern\"/>"));
        CommandResult result = command("controller", file.toString());
        assertEquals(2, result.code);
        assertTrue(
                result.err.startsWith("faultline: the scenario is driven by a controller from outside;"), result.err);
    }

    @Test
    void aHostileArgumentIsCutAndKeptOnOneLine() {
        CommandResult outcome = command("--" + "x\n".repeat(10_000));
        assertEquals(2, outcome.code);
        assertTrue(outcome.err.lines().count() == 1 && outcome.err.length() < 300, outcome.err);
    }

    @ParameterizedTest
    @CsvSource({"run none.xml", "none.xml", "check none.xml"})
    void aFileThatIsNotThereIsExitCodeTwoAndOneLine(String arguments) {
        assertEquals(new CommandResult(2, "", "none.xml: there is no such file\n"), command(arguments.split(" ")));
    }

    @Test
    void theSummaryAsJsonHasTheKeysAndValuesOfTheLines() throws Exception {
        CommandResult lines = command("run", COLLIDING_SCENARIO);
        CommandResult json = command("run", COLLIDING_SCENARIO, "--json");
        assertEquals(1, json.out.lines().count());
        Map<?, ?> members = (Map<?, ?>) JsonParser.parse(json.out.strip());
        assertEquals(2000.0, members.get("ticks"));
        assertEquals(lines.value("trajectory_hash"), members.get("trajectory_hash"));
        assertEquals(List.of(lines.value("states").split(" ")), members.get("states"));
        assertEquals(2.125, (Double) ((Map<?, ?>) members.get("collision")).get("x_m"), 1e-9);
        assertEquals("visitor", members.get("collided_with"));
        assertEquals(JsonParser.NULL, members.get("coverage"));
        assertEquals("held", members.get("expectations"));
    }

    @Test
    void aPacedRunTakesItsTimeAndChangesNothing() {
        String hash = command("run", COLLIDING_SCENARIO, "--until", "3").value("trajectory_hash");
        long start = System.nanoTime();
        CommandResult paced = command("run", COLLIDING_SCENARIO, "--until", "3", "--pace", "6");
        double seconds = (System.nanoTime() - start) / 1e9;
        assertEquals(hash, paced.value("trajectory_hash"));
        assertTrue(seconds >= 0.5, () -> seconds + " s");
        assertTrue(Double.parseDouble(paced.value("real_time_factor")) <= 6.01, paced.out);
    }

    @Test
    void aFilmShowsTheRunAtRealTime() throws Exception {
        Path film = folder.resolve("run.gif");
        command("run", COLLIDING_SCENARIO, "--until", "2", "--film", film.toString());
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        try (ImageInputStream in = ImageIO.createImageInputStream(film.toFile())) {
            reader.setInput(in);
            assertEquals(21, reader.getNumImages(true), "one picture each tenth of a second, from 0 to 2 s");
            assertEquals(640, reader.getWidth(0));
        } finally {
            reader.dispose();
        }
        byte[] bytes = Files.readAllBytes(film);
        assertEquals(';', bytes[bytes.length - 1], "the trailer of a GIF");
    }

    @Test
    void aScenarioThatWantsAControllerFromOutsideStartsNone() throws Exception {
        String text = Files.readString(Path.of("scenarios/yard.xml"))
                .replace("</scenario>", "<controller type=\"extern\" period=\"0.02\"/></scenario>");
        Path file = Files.writeString(folder.resolve("extern.xml"), text);
        CommandResult run = command("run", file.toString());
        assertEquals(2, run.code);
        assertTrue(run.err.contains("choose one with --controller"), run.err);
        CommandResult chosen = command("run", file.toString(), "--until", "1", "--controller", "wall-follower");
        assertEquals("SEARCH", chosen.value("state"), chosen.err);
    }

    @Test
    void aControllerThatIsGivenTheTruthIsNamedInTheSummary() {
        String child = "sh -c 'read hello; echo \"{\\\"type\\\":\\\"ready\\\",\\\"protocol\\\":1}\"; read line;"
                + " case $line in *truth*) echo \"{\\\"type\\\":\\\"drive\\\",\\\"tick\\\":0,"
                + "\\\"left_v\\\":1,\\\"right_v\\\":1}\";; esac; read end; echo \"$end\" >&2'";
        CommandResult run = command("run", COLLIDING_SCENARIO, "--until", "0.01", "--truth", "--controller", child);
        assertEquals("given to the controller", run.value("truth"), run.err);
        assertTrue(run.err.contains("\"summary\":{\"truth\":\"given to the controller\",\"ticks\":\"1\","), run.err);
    }

    @Test
    void everyLineOfTheSummaryIsExplained() throws IOException {
        String page = Files.readString(Path.of("docs/traces.md"));
        List<String> unexplained = command("run", COLLIDING_SCENARIO, "--until", "12")
                .out
                .lines()
                .map(line -> line.split(": ")[0])
                .filter(key -> !page.contains("`" + key + "`"))
                .toList();
        assertEquals(List.of(), unexplained);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "run",
                "check",
                "compare",
                "serve",
                "controller",
                "import",
                "campaign",
                "merge",
                "report",
                "figures"
            })
    void helpAfterACommandIsThePartOfThatCommand(String name) {
        CommandResult help = command(name, "--help");
        assertEquals(0, help.code);
        assertTrue(help.out.startsWith("faultline " + name + " "), help.out);
        assertEquals(help, command("--help", name));
        assertEquals(help, command("help", name));
        assertEquals(help, command(name, "-h"));
        List<String> others = help.out
                .lines()
                .skip(1)
                .filter(line -> line.startsWith("faultline "))
                .toList();
        assertEquals(List.of(), others);
        assertTrue(command("--help").out.contains(help.out.lines().findFirst().orElseThrow()), help.out);
    }

    @ParameterizedTest
    @ValueSource(strings = {"--help", "-h"})
    void helpAfterAnOptionThatTakesAValueIsNotItsValue(String help) {
        CommandResult value = command("run", COLLIDING_SCENARIO, "--trace", help);
        assertEquals(
                "faultline: --trace needs a value, and \"" + help + "\" is an option (see faultline --help)\n",
                value.err);
        assertEquals(2, value.code);
        assertTrue(Files.notExists(Path.of(help)));
        assertEquals(command("run", help), command("run", COLLIDING_SCENARIO, "--truth", help), "after a flag");
        assertEquals(command("run", help), command("run", "--trase", help), "after a misspelt option");
        assertEquals(command("--version", "--help"), command("--version", help));
    }

    @Test
    void helpNamesEveryCommandAndOption() {
        CommandResult help = command("--help");
        assertEquals(0, help.code);
        assertEquals(help, command("help"));
        assertEquals(help, command("-h"));
        Stream.of(
                        "run FILE",
                        "--until",
                        "--seed",
                        "--threads",
                        "--trace",
                        "--image",
                        "--journal",
                        "check",
                        "--version",
                        "Exit codes")
                .forEach(word -> assertTrue(help.out.contains(word), word));
    }

    /** A user of a package has no jar at the place of the build. */
    @Test
    void theHelpOfAPackageNamesNoJar() {
        assertTrue(command("--help").out.contains("\"faultline\" stands for: java -jar target/faultline.jar"));
        System.setProperty("faultline.command", "faultline");
        try {
            CommandResult help = command("--help");
            assertEquals(0, help.code);
            assertTrue(!help.out.contains("stands for") && !help.out.contains("target/"), help.out);
        } finally {
            System.clearProperty("faultline.command");
        }
    }

    @Test
    void versionIsOneLine() {
        CommandResult version = command("--version");
        assertEquals(0, version.code);
        assertTrue(version.out.matches("faultline \\S.*\n"), version.out);
    }

    @Test
    void aClosedPipeIsExitCodeTwo() {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        OutputStream closed = new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("broken pipe");
            }
        };
        assertEquals(2, new CommandLine(new CommandOutput(stream(closed), stream(err))).run("--help"));
        assertEquals("faultline: standard output cannot be written\n", err.toString(StandardCharsets.UTF_8));
    }

    /** A controller may make its exceptions causes of each other. */
    @Test
    void theRootOfACircleOfCausesIsOneOfThem() {
        RuntimeException first = new RuntimeException("first");
        RuntimeException second = new RuntimeException("second", first);
        first.initCause(second);
        assertSame(first, CommandLine.rootCause(first));
        assertSame(first, CommandLine.rootCause(new IllegalStateException(first)));
    }
}
