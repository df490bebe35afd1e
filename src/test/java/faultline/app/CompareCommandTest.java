package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import faultline.campaign.run.Csv;
import faultline.io.ShellText;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Controllers are compared in one scenario; the table, the page and the replays agree with single runs. */
class CompareCommandTest {

    private static final String SCENARIO = "scenarios/noisy-sensors.xml";
    private static final String STRAIGHT =
            "sh -c 'read h; echo \"{\\\"type\\\":\\\"ready\\\",\\\"protocol\\\":1}\"; i=0; "
                    + "while read l; do case $l in *observe*) echo \"{\\\"type\\\":\\\"drive\\\",\\\"tick\\\":$i,"
                    + "\\\"left_v\\\":2,\\\"right_v\\\":2.1}\";; esac; i=$((i+1)); done'";

    @TempDir
    private Path folder;

    /** The result of a command. */
    private record CommandResult(int code, String out, String err) {}

    private static CommandResult command(String... args) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        int code = new CommandLine(new CommandOutput(
                        new PrintStream(out, true, StandardCharsets.UTF_8),
                        new PrintStream(err, true, StandardCharsets.UTF_8)))
                .run(args);
        return new CommandResult(code, out.toString(StandardCharsets.UTF_8), err.toString(StandardCharsets.UTF_8));
    }

    private CommandResult compare(String... more) {
        return command(Stream.concat(Stream.of("compare", SCENARIO, "--out", page().toString()), Stream.of(more))
                .toArray(String[]::new));
    }

    private Path page() {
        return folder.resolve("page.html");
    }

    private List<String> table() throws Exception {
        return Files.readAllLines(folder.resolve("page.csv"));
    }

    private static String hash(String... arguments) {
        return command(arguments)
                .out
                .lines()
                .filter(line -> line.startsWith("trajectory_hash: "))
                .findFirst()
                .orElseThrow()
                .substring(17);
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
    void theTableHoldsEveryRunAndEachReplaysWithoutItsController() throws Exception {
        CommandResult result =
                compare("--controller", "wall-follower", "--controller", STRAIGHT, "--seeds", "2", "--until", "6");
        assertEquals(0, result.code, result.err);
        List<String> rows = table();
        assertEquals(5, rows.size(), rows::toString);
        String[] second = rows.get(2).split(",", -1);
        assertEquals("wall-follower", second[0]);
        assertEquals(hash("run", SCENARIO, "--until", "6", "--seed", second[1]), second[second.length - 2]);
        for (int number = 1; number <= 2; number++) {
            String[] first = rows.get(2 * number - 1).split(",", -1);
            assertEquals(hash("run", folder.resolve("page-" + number + ".xml").toString()), first[first.length - 2]);
        }
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "it has no /dev/null")
    void aPageThatIsADeviceHasNoFilesBesideIt() throws Exception {
        Path page = Files.createSymbolicLink(page(), Path.of("/dev/null"));
        CommandResult result = compare("--controller", "none", "--controller", "wall-follower", "--until", "1");
        assertEquals(0, result.code, result.err);
        assertTrue(result.out.contains("page: " + page + "\n"), result.out);
        assertFalse(result.out.contains("table: ") || result.out.contains("replay: "), result.out);
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(List.of(page), files.toList());
        }
    }

    @Test
    void controllersAndOtherValuesMayFollowAnEqualsSign() throws Exception {
        assertEquals(0, compare("--controller", "none", "--controller", "wall-follower", "--until", "1").code);
        List<String> separate = table();
        assertEquals(0, compare("--controller=none", "--controller=wall-follower", "--until=1").code);
        assertEquals(separate, table());
    }

    @Test
    void aDifferenceIsTheMeanOverPairsOfRunsWithTheSameSeed() throws Exception {
        CommandResult result =
                compare("--controller", "none", "--controller", "wall-follower", "--seeds", "3", "--until", "6");
        assertEquals(0, result.code, result.err);
        List<String> lines = result.out.lines().toList();
        String moving = lines.get(2).substring(lines.get(2).lastIndexOf("  ") + 2);
        assertTrue(moving.matches("\\d\\.\\d\\d \\[.*]"), lines::toString);
        // A robot that stands still has a path of 0 m; Wilson's interval of 0 in 3 runs ends at 0.56.
        assertEquals(List.of("2 less 1", "3 pairs", "none", "none", "0.00 [-0.56, 0.56]", moving), cells(lines.get(3)));
        assertFalse(result.out.contains("random"), result.out);
        assertTrue(Files.readString(page()).contains("Differences to none in runs with the same seed"));
    }

    @Test
    void seedsThatMakeNoDifferenceAreReported() {
        String[] controllers = {"--controller", "none", "--controller", "wall-follower"};
        String file = "scenarios/yard.xml";
        String out = command(Stream.concat(
                                Stream.of("compare", file, "--out", "" + page(), "--seeds", "2", "--until", "1"),
                                Stream.of(controllers))
                        .toArray(String[]::new))
                .out;
        assertTrue(out.contains("\nseeds: nothing in these runs is random, so every seed gives the same run\n"), out);
    }

    /** The child drives each run with other voltages. */
    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
    void theEqualRunsOfOneOfTheControllersCountOnce() throws Exception {
        Path count = folder.resolve("count");
        String varying = STRAIGHT.replace("i=0; ", "echo x >> " + count + "; n=$(wc -l < " + count + "); i=0; ")
                .replace("2.1", "2.$n");
        CommandResult result = command(
                "compare",
                "scenarios/yard.xml",
                "--out",
                page().toString(),
                "--controller",
                "wall-follower",
                "--controller",
                varying,
                "--seeds",
                "3",
                "--until",
                "2");
        assertEquals(0, result.code, result.err);
        List<String> lines = result.out.lines().toList();
        assertEquals(List.of("wall-follower", "3"), cells(lines.get(1)).subList(0, 2));
        assertEquals("0.00", cells(lines.get(1)).get(4), "no interval of one run");
        assertTrue(cells(lines.get(2)).get(4).startsWith("0.00 ["), lines::toString);
        String remark = "he completed runs of wall-follower have the same results and count once";
        assertTrue(result.out.contains("\nseeds: t" + remark + "\n"), result.out);
        assertTrue(Files.readString(page()).contains(" T" + remark + "."));
    }

    /** A robot that drives by constant voltages meets no noise, but its sensors do. */
    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
    void runsThatOnlyReadNoiseCountOnce() {
        CommandResult result =
                compare("--controller", "none", "--controller", STRAIGHT, "--seeds", "3", "--until", "5");
        assertEquals(0, result.code, result.err);
        List<String> lines = result.out.lines().toList();
        assertEquals("0.00", cells(lines.get(2)).get(4), "no interval of one run");
        assertEquals("0.00", cells(lines.get(3)).get(4), "no interval of one pair");
        assertTrue(result.out.contains("\nseeds: the completed runs of none have the same results and count once\n"));
        assertFalse(result.out.contains("random"), result.out);
    }

    private static List<String> cells(String line) {
        return List.of(line.split(" {2,}"));
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
    void aComparisonSaysThatControllersWereGivenTheTruth() throws Exception {
        CommandResult result = compare("--controller", "none", "--controller", STRAIGHT, "--until", "1", "--truth");
        assertEquals(0, result.code, result.err);
        assertTrue(result.out.startsWith("truth: given to the controllers in child processes\n"), result.out);
        assertTrue(Files.readString(page()).contains("Controllers in child processes were given the ground truth."));
        assertFalse(result.out.contains("\nwindow: "), "the window does not give it to them");
        CommandResult none = compare("--controller", "none", "--controller", "wall-follower", "--truth");
        assertEquals(2, none.code, none.out);
        assertEquals("faultline: --truth needs --controller COMMAND (see faultline --help)\n", none.err);
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
    void theLengthOfThePathCountsMovesThatArePaintedAsOnePoint() throws Exception {
        // Three volts to and fro, in turn for two ticks: less than 0.3 m/s for 20 ms, which is 6 mm.
        String shaking = STRAIGHT.replace(
                        "\\\"left_v\\\":2,\\\"right_v\\\":2.1", "\\\"left_v\\\":$v,\\\"right_v\\\":$v")
                .replace("while read l; do", "while read l; do v=$((3-i/2%2*6));");
        CommandResult result = compare("--controller", "none", "--controller", shaking, "--until", "4");
        assertEquals(0, result.code, result.err);
        Path trace = folder.resolve("trace.csv");
        command("run", SCENARIO, "--until", "4", "--controller", shaking, "--trace", "" + trace);
        double metres = 0;
        double[] first = null;
        double[] last = null;
        for (String row : Files.readAllLines(trace).subList(1, 402)) {
            String[] cells = row.split(",");
            double[] place = {Double.parseDouble(cells[2]), Double.parseDouble(cells[3])};
            metres += last == null ? 0 : Math.hypot(place[0] - last[0], place[1] - last[1]);
            first = first == null ? place : first;
            last = place;
        }
        assertTrue(Math.hypot(last[0] - first[0], last[1] - first[1]) < 0.006, "it shakes in its place");
        assertTrue(metres > 0.05, metres + " m");
        List<String> shaken = Csv.cells(table().get(2));
        double counted = Double.parseDouble(shaken.get(Csv.cells(table().get(0)).indexOf("path_m")));
        assertEquals(metres, counted, 1e-9);
    }

    /** A controller of the program has the distance of its timeline from 0.5 s on, and another one has not. */
    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
    void commandsThatAControllerDoesNotTakeAreReported() throws Exception {
        Path file = Files.writeString(
                folder.resolve("distance.xml"),
                """
                <scenario xmlns="urn:faultline:scenario:1" name="C" duration="1">
                  <world width="3" height="3"/>
                  <robot x="1.2" y="1"/>
                  <timeline><controller at="0.5" distance="0.3"/></timeline>
                </scenario>
                """);
        String[] words = {
            "compare", "" + file, "--out", "" + page(), "--seeds", "2", "--controller", "wall-follower", "--controller"
        };
        String refusal = "refused at 0.5 s: the controller is not part of the program and has no settings here";
        CommandResult result =
                command(Stream.concat(Stream.of(words), Stream.of(STRAIGHT)).toArray(String[]::new));
        assertEquals(0, result.code, result.err);
        assertEquals("the controller \"" + STRAIGHT + "\": " + refusal + "\n", result.err);
        String html = Files.readString(page());
        assertTrue(html.contains("<h2>Refused commands</h2>"), "the page has a section");
        assertEquals(1, count("<td>" + refusal + "</td>", html), "one controller refuses the command");
        CommandResult none =
                command(Stream.concat(Stream.of(words), Stream.of("none")).toArray(String[]::new));
        assertEquals("", none.err);
        assertFalse(Files.readString(page()).contains("efused"), "no section");
    }

    @Test
    void thePageHasWhatAReaderNeedsToRepeatTheRuns() throws Exception {
        Path file = folder.resolve("broken.xml");
        Files.writeString(
                file,
                Files.readString(Path.of(SCENARIO))
                        .replace(
                                "  <expect",
                                "<timeline><fault at='0.5' sensor='front' kind='stuck' value='0.4'/>"
                                        + "<switch at='0.75' sensor='left' on='false'/>"
                                        + "<remove at='0.8' obstacle='cabinet'/></timeline><expect"));
        String[] words = "--controller none --controller wall-follower --seeds 3 --until 1".split(" ");
        CommandResult result =
                command(Stream.concat(Stream.of("compare", "" + file, "--out", "" + page()), Stream.of(words))
                        .toArray(String[]::new));
        assertEquals(0, result.code, result.err);
        String html = Files.readString(page());
        String conditions = "Scenario file: broken.xml. Seeds: 1 to 3. Duration: 1 s."
                + " Timeline: front stuck=0.4 at 0.5 s, left switched off at 0.75 s, 1 other change."
                + " Version: faultline ";
        assertTrue(html.contains("<p>" + conditions), html);
        assertFalse(html.contains("are the same."), html);
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
    void controllersWithTheSameRunsAreNamed() throws Exception {
        String other = STRAIGHT.replace("i=0; ", "i=0;  ");
        CommandResult result =
                compare("--controller", STRAIGHT, "--controller", "none", "--controller", other, "--until", "1");
        assertEquals(0, result.code, result.err);
        String remark = "he completed runs of the controllers 1 and 3 are the same";
        assertTrue(result.out.contains("\nruns: t" + remark + "\n"), result.out);
        assertTrue(Files.readString(page()).contains(" T" + remark + "."));
    }

    @Test
    void thePageNeedsNothingButItself() throws Exception {
        CommandResult result =
                compare("--controller", "wall-follower", "--controller", "none", "--seeds", "3", "--until", "5");
        assertEquals(0, result.code, result.err);
        String html = Files.readString(page());
        assertFalse(html.matches("(?s).*(src|href)=.*"), "the page refers to something else");
        assertTrue(html.contains("<code>wall-follower</code>"));
        String picture = html.substring(html.indexOf("<svg"), html.indexOf("</svg>"));
        assertEquals(2 * 3, count("<circle [^>]* r=\"3\"", picture), "the end of every run");
        assertEquals(3, count("d=\"M[^\"Z]*\" fill=\"none\" stroke=\"#0b4f79\"", picture), "one robot drives");
        assertTrue(html.length() < 300_000, () -> html.length() + " characters");
    }

    /** The first 100 are drawn. */
    @ParameterizedTest
    @CsvSource({"100, 100", "101, 100"})
    void thePicturesOfManySeedsShowTheFirstHundred(int seeds, int drawn) throws Exception {
        String words = "--controller wall-follower --controller none --until 0.1 --seeds " + seeds;
        CommandResult result = compare(words.split(" "));
        assertEquals(0, result.code, result.err);
        assertEquals(1 + 2 * seeds, table().size(), "a row for each run");
        String html = Files.readString(page());
        String picture = html.substring(html.indexOf("<svg"), html.indexOf("</svg>"));
        assertEquals(2 * drawn, count("<circle [^>]* r=\"3\"", picture));
        assertEquals(seeds > drawn, html.contains(" Only the runs with the first 100 seeds are drawn."));
    }

    @Test
    void theOutputAndThePageNameTheCommandThatShowsTheGhost() throws Exception {
        CommandResult result = compare("--controller", "wall-follower", "--controller", "none", "--until", "1");
        String command = "java -jar target/faultline.jar scenarios/noisy-sensors.xml --controller wall-follower"
                + " --ghost-controller none";
        assertTrue(result.out.lines().anyMatch(("window: " + command)::equals), result.out);
        String page = Files.readString(page());
        assertTrue(page.contains("<code>" + command + "</code>"));
        // The table "worst" aligns its first column, the numbers of runs, to the right.
        assertFalse(page.contains("<table class=\"worst\">"));
    }

    /** Runs a command in a process without a display. */
    private static CommandResult commandWithoutDisplay(String... args) throws Exception {
        ProcessBuilder builder = JavaProcess.builder("faultline.app.Main", List.of(args));
        builder.command().add(1, "-Djava.awt.headless=true");
        Process process = builder.start();
        String out = JavaProcess.output(process);
        String err = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
        return new CommandResult(process.waitFor(), out, err);
    }

    @Test
    void aMisspeltOptionOfTheWindowIsNamed() {
        CommandResult misspelt = command(SCENARIO, "--controller", "none", "--ghost-controler", "wall-follower");
        assertEquals(2, misspelt.code);
        assertTrue(misspelt.err.contains("did you mean \"--ghost-controller\""), misspelt.err);
    }

    @Test
    void theWindowTakesControllersButOnlyWithADisplay() throws Exception {
        CommandResult window =
                commandWithoutDisplay(SCENARIO, "--controller", "none", "--ghost-controller", "wall-follower");
        assertEquals(2, window.code);
        assertTrue(window.err.contains("--controller needs a display here"), window.err);
        String extern = Files.readString(Path.of("scenarios/yard.xml"))
                .replace("</scenario>", "<controller type=\"extern\"/></scenario>");
        CommandResult alone = commandWithoutDisplay(
                Files.writeString(folder.resolve("extern.xml"), extern).toString());
        assertEquals(2, alone.code, alone.out);
        assertTrue(alone.err.contains("choose one with --controller"), alone.err);
        CommandResult ghost = commandWithoutDisplay(SCENARIO, "--ghost-controller", "wall-follower");
        assertTrue(ghost.err.contains("--ghost-controller needs a display here"), ghost.err);
        CommandResult compared = commandWithoutDisplay(
                "compare",
                SCENARIO,
                "--out",
                "" + page(),
                "--controller",
                "wall-follower",
                "--controller",
                "none",
                "--open");
        assertEquals(2, compared.code);
        assertTrue(compared.err.contains("--open needs a display here"), compared.err);
        assertFalse(Files.exists(page()), "no page is written");
    }

    @ParameterizedTest
    @ValueSource(strings = {"none", "python3 my.py", "sh -c 'exit 5'", "a \"b\" $HOME `c` \\ it's!", "", "ü*?"})
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "needs a shell")
    void aShellUnderstandsTheQuotedWordsOfACommand(String word) throws Exception {
        Process shell = new ProcessBuilder("sh", "-c", "printf %s " + ShellText.quoted(word)).start();
        assertEquals(word, JavaProcess.output(shell));
        assertEquals(0, shell.waitFor());
    }

    private static long count(String pattern, String text) {
        return Pattern.compile(pattern).matcher(text).results().count();
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
    void aControllerThatBreaksIsReportedAndTheOthersRun() throws Exception {
        CommandResult result = compare("--controller", "none", "--controller", "sh -c 'exit 5'", "--until", "1");
        assertEquals(3, result.code);
        assertTrue(result.err.contains("ended with exit code 5 before the first tick"), result.err);
        assertTrue(table().get(2)
                .endsWith(
                        "\"the controller \"\"sh -c 'exit 5'\"\" ended with exit code 5 before the" + " first tick\""));
        assertTrue(Files.readString(page()).contains("Broken runs"));
    }

    /** A program may be built again, or its start may need memory that there is not, while others have finished. */
    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
    void aProgramThatCannotBeStartedForALaterSeedFailsInThatRunOnly() throws Exception {
        Path program = folder.resolve("once.sh");
        String script = STRAIGHT.substring("sh -c '".length(), STRAIGHT.length() - 1);
        Files.writeString(program, "#!/bin/sh\nrm \"$0\"\n" + script + "\n");
        assertTrue(program.toFile().setExecutable(true));
        CommandResult result =
                compare("--controller", "none", "--controller", "" + program, "--until", "1", "--seeds", "2");
        assertEquals(3, result.code, result.err);
        assertTrue(result.err.contains("cannot be started: there is no such program"), result.err);
        assertEquals(5, table().size(), "a row for each run");
        assertTrue(Files.readString(page()).contains("Broken runs"));
        assertTrue(Files.exists(folder.resolve("page-2.xml")), "the first run of the program was finished");
        Files.delete(page());
        assertEquals(2, compare("--controller", "none", "--controller", "" + program, "--until", "1").code);
        assertTrue(Files.notExists(page()), "a name that is wrong from the start is no run");
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
    void aReplayOfAnEarlierComparisonIsNotLeftBesideOneWithoutIt() throws Exception {
        compare("--controller", "none", "--controller", "wall-follower", "--until", "1");
        assertTrue(Files.exists(folder.resolve("page-2.xml")));
        CommandResult result = compare("--controller", "none", "--controller", "sh -c 'exit 5'", "--until", "1");
        assertEquals(3, result.code);
        assertTrue(Files.exists(folder.resolve("page-1.xml")));
        assertFalse(Files.exists(folder.resolve("page-2.xml")), "the second controller has no replay");
    }

    @Test
    void aReplayThatCannotBeSavedIsReportedLastAndAnOldOneIsDeleted() throws Exception {
        Path file = OutputFilesTest.scenarioWithTooLongAJournal(folder);
        List<Path> replays = List.of(folder.resolve("page-1.xml"), folder.resolve("page-2.xml"));
        Files.writeString(replays.get(0), "<scenario xmlns=\"urn:faultline:scenario:1\" recorded=\"true\"/>");
        CommandResult result = command(
                "compare",
                file.toString(),
                "--out",
                page().toString(),
                "--controller",
                "none",
                "--controller",
                "wall-follower");
        assertEquals(2, result.code);
        assertFalse(result.out.contains("replay: "), result.out);
        String reason = ": the scenario cannot be saved: the file has 18.1 MiB; expected at most 16 MiB";
        assertEquals(
                replays.stream().map(replay -> "faultline: " + replay + reason).toList(),
                result.err.lines().toList());
        assertEquals(3, table().size());
        assertFalse(Files.exists(replays.get(0)), "the replay would seem to be of this comparison");
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
    void everyChildIsInformedOfTheEndOfItsRun() {
        String child = STRAIGHT.replace(";; esac", ";; *) echo \"$l\" >&2;; esac");
        CommandResult result = compare("--controller", "none", "--controller", child, "--until", "1", "--seeds", "2");
        assertEquals(0, result.code, result.err);
        List<String> ends = result.err.lines().toList();
        assertEquals(2, ends.size(), result.err);
        assertTrue(
                ends.get(1).startsWith("{\"type\":\"end\",\"reason\":\"duration\",\"trajectory_hash\":\""), result.err);
    }

    /** The seeds after the greatest one would be negative. */
    @Test
    void seedsBeyondTheGreatestAreRefused() throws Exception {
        Path file = Files.writeString(
                folder.resolve("last-seeds.xml"),
                """
                <scenario xmlns="urn:faultline:scenario:1" seed="9223372036854775806" duration="1">
                  <world width="4" height="3"/><robot x="2" y="1"/>
                </scenario>
                """);
        String[] two = ("compare " + file + " --controller none --controller wall-follower --out " + page()).split(" ");
        String[] three =
                Stream.concat(Stream.of(two), Stream.of("--seeds", "3")).toArray(String[]::new);
        CommandResult refused = command(three);
        assertEquals(2, refused.code);
        assertEquals(
                "faultline: --seeds is \"3\"; expected at most 2, because the first seed is 9223372036854775806 and the"
                        + " last possible one 9223372036854775807 (see faultline --help)",
                refused.err.lines().findFirst().orElseThrow());
        assertFalse(Files.exists(page()));
        three[three.length - 1] = "2";
        assertEquals(0, command(three).code);
        assertTrue(table().get(2).startsWith("none,9223372036854775807,"), table().get(2));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            --controller none                                | compare needs --controller at least twice, each time with another one
            --controller none --controller none              | compare needs --controller at least twice, each time with another one
            --controller none --controller wall-follower --seeds 0 | --seeds is "0"; expected a whole number from 1 to 10000
            --controller none --controller                   | --controller needs a value
            --controller none --controller x --sead 3        | there is no option "--sead" here
            --controller none --until --controller wall-follower | --until needs a value, and "--controller" is an option
            """)
    void badUsageIsOneSentence(String arguments, String sentence) {
        CommandResult result = compare(arguments.split(" "));
        assertEquals(2, result.code);
        assertTrue(result.err.startsWith("faultline: " + sentence), result.err);
        assertEquals(1, result.err.lines().count());
    }
}
