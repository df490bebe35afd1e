package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.CpuTime;
import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.PlanFiles;
import faultline.campaign.plan.SamplePlan;
import faultline.campaign.run.CampaignFolder;
import faultline.campaign.run.CampaignRunner;
import faultline.campaign.run.Csv;
import faultline.campaign.run.Shard;
import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.xml.sax.InputSource;

class CampaignReportTest {

    @TempDir
    Path folder;

    private String report(String elements) throws Exception {
        String worlds = "<worlds><scenario file=\"a.xml\"/><scenario file=\"b.xml\"/></worlds>"
                + (elements.contains("<seeds") ? "" : "<seeds count=\"2\"/>");
        return reportOf(worlds + elements);
    }

    private String reportOf(String elements) throws Exception {
        return reportOf(elements, SamplePlan.ROOM);
    }

    private String reportOf(String elements, String room) throws Exception {
        CampaignPlan plan = SamplePlan.read(SamplePlan.text("", elements), room);
        new CampaignRunner(plan, new CampaignFolder(folder), Shard.ALL, 2).run(true, (made, runs) -> {}, () -> false);
        return new CampaignReport(folder).html(List.of());
    }

    @Test
    void aCampaignWithFaultsHasAMatrixAndComparisons() throws Exception {
        String html = report(
                """
                <set attribute="controller/@distance" value="0.2 0.25 0.3"/>
                <set attribute="robot/@speed" value="0.2..0.4"/>
                <faults><healthy/><fault kind="off stuck" sensor="front left" at="1..3"/></faults>
                """);
        assertEquals(
                List.of(
                        "Summary",
                        "Survival by fault and sensor",
                        "controller_distance_m: 0.2, 0.25, 0.3",
                        "Detection delays",
                        "Distributions",
                        "Worst runs",
                        "Columns of runs.csv"),
                headings(html));
        assertTrue(html.contains("<th scope=\"row\">stuck</th>"));
        Pattern varied = Pattern.compile("<td>controller_distance_m [\\d.]+, robot_speed_m_s [\\d.]+, fault_kind ");
        assertTrue(varied.matcher(html).find(), "the worst runs say what varies");
        assertTrue(html.contains("java -jar target/faultline.jar " + folder.resolve("replays/run-")));
    }

    @Test
    void theSummaryNamesScenariosWithFaultsOfTheirOwn() throws Exception {
        String elements = "<worlds><scenario file=\"a.xml\"/></worlds><faults><healthy/></faults>";
        String sentence = "Scenarios with such faults: a.";
        String without = reportOf(elements);
        assertFalse(without.contains(sentence));
        assertTrue(without.contains("All runs are in one world"), without);
        String limits = "in the time of 2 laps after the fault, passes at least 0.80 of the wall that it follows within"
                + " 0.15 m of the wanted path. ";
        assertTrue(without.contains(limits), without);
        folder = folder.resolve("faulty");
        String fault = "<timeline><fault at=\"1\" sensor=\"front\" kind=\"off\"/></timeline></scenario>";
        String html = reportOf(elements, SamplePlan.ROOM.replace("</scenario>", fault));
        assertTrue(html.contains(sentence), html);
    }

    @Test
    void theSummaryNamesWhatATimelineReplaces() throws Exception {
        String elements =
                """
                <worlds><scenario file="a.xml"/></worlds>
                <set attribute="controller/@diagnosis" value="on off"/>
                <set attribute="controller/@distance" value="0.2"/>
                <set attribute="controller/@period" value="0 0.1"/>
                """;
        String sentence = "Attributes of the controller that are replaced: diagnosis, distance in a.";
        assertFalse(reportOf(elements).contains("are replaced"));
        folder = folder.resolve("changed");
        String change = "<timeline><controller at=\"1\" distance=\"0.3\" diagnosis=\"on\"/></timeline></scenario>";
        String html = reportOf(elements, SamplePlan.ROOM.replace("</scenario>", change));
        assertTrue(html.contains(sentence), html);
    }

    @Test
    void aShellUnderstandsTheCommandOfAWorstRun() throws Exception {
        folder = folder.resolve("my <runs>");
        String html = report("");
        String command = "java -jar target/faultline.jar \"" + folder.resolve("replays/run-0000000.xml") + "\"";
        assertTrue(html.contains("<code>" + Html.escape(command) + "</code>"), html);
    }

    @Test
    void namesInAPlanAreNoMarkup() throws Exception {
        String html = reportOf(
                """
                <worlds><scenario file="a.xml" name="&lt;i>"/></worlds><seeds count="2"/>
                <variants><variant name="&lt;u>"/>
                  <variant name="&lt;em>"><set attribute="robot/@speed" value="0.2"/></variant></variants>
                <faults><healthy/><fault label="&lt;s>" kind="off" sensor="front" at="1"/></faults>
                """);
        for (String name : List.of("i", "u", "em", "s")) {
            assertFalse(html.contains("<" + name + ">"), name);
            assertTrue(html.contains("&lt;" + name + "&gt;"), name);
        }
    }

    /** The table may come from another machine, and the page is opened in a browser. */
    @Test
    void cellsOfTheTableAreNoMarkup() throws Exception {
        report("<faults><fault kind=\"off\" sensor=\"front left\" at=\"1\"/></faults>");
        Path table = folder.resolve("runs.csv");
        List<String> names = Csv.cells(Files.readAllLines(table).get(0));
        List<String> lines = new ArrayList<>(List.of(Csv.row(names).strip()));
        for (String row : Files.readAllLines(table).subList(1, 9)) {
            List<String> cells = Csv.cells(row);
            for (String column : List.of("seed", "world", "collided_with", "final_state", "failure")) {
                cells.set(names.indexOf(column), "<script>" + column + "</script>");
            }
            lines.add(Csv.row(cells).strip());
        }
        Files.write(table, lines);
        String html = new CampaignReport(folder).html(List.of());
        assertTrue(html.contains("&lt;script&gt;seed"), "the worst runs name their seeds");
        assertFalse(html.contains("<script"), html);
    }

    @Test
    void chartsOfOneColumnHaveTitlesThatNameTheirFaults() throws Exception {
        String html = report(
                """
                <seeds count="8"/>
                <faults><fault kind="stuck scale" sensor="front" value="0.3..0.6" at="1..3"/></faults>
                """);
        assertTrue(html.contains("<title>carried on over fault_value, stuck</title>"), html);
        assertTrue(html.contains("<title>carried on over fault_value, scale</title>"), html);
    }

    @Test
    void aCampaignWithMasksHasMinimumSets() throws Exception {
        String html = report("<masks sensors=\"front left\"/>");
        assertTrue(headings(html).contains("Minimum sets of sensors"));
        assertTrue(html.contains("<th scope=\"row\">0</th><td>1</td>"), "the empty set");
        assertTrue(html.contains("; 0 are certain."), "two runs are too few to be certain");
        assertTrue(html.contains(">simulated_s, n 16<"), "a distribution says of how many runs it is");
    }

    @Test
    void everySizeOfAListedSetHasARow() throws Exception {
        String ids = IntStream.range(0, 20).mapToObj(i -> "s" + i).collect(Collectors.joining(" "));
        String sensors = IntStream.range(0, 20)
                .mapToObj(i -> "<sensor id=\"s" + i + "\" x=\"0\" y=\"0\" bearing=\"" + 18 * i + "\"/>")
                .collect(Collectors.joining("", "<robot x=\"0.6\" y=\"1.2\">", "</robot>"));
        Files.writeString(folder.resolve("a.xml"), SamplePlan.ROOM.replace("<robot x=\"0.6\" y=\"1.2\"/>", sensors));
        Path file = Files.writeString(
                folder.resolve("plan.xml"),
                SamplePlan.text(
                        "",
                        """
                        <worlds><scenario file="a.xml"/></worlds>
                        <set attribute="@duration" value="1"/>
                        <masks sensors="IDS"><mask on="IDS"/><mask on="s0"/></masks>
                        """
                                .replace("IDS", ids)));
        Path out = folder.resolve("a folder");
        new CampaignRunner(PlanFiles.read(file), new CampaignFolder(out), Shard.ALL, 1)
                .run(false, (made, runs) -> {}, () -> false);
        String html = new CampaignReport(out).html(List.of());
        assertTrue(html.contains("<th scope=\"row\">1</th><td>1</td>"), "one sensor");
        assertTrue(html.contains("<th scope=\"row\">20</th><td>1</td>"), "twenty sensors");
        assertTrue(html.contains("java -jar target/faultline.jar &quot;" + out.resolve("replays/run-")), "in quotes");
        assertTrue(html.contains(".xml&quot;</code>"), "no jar");
        String withJar = new CampaignReport(out).html(List.of(Path.of("my controller.jar")));
        assertTrue(
                withJar.contains(".xml&quot; --jar &quot;my controller.jar&quot;</code>"),
                "a run needs its controller");
    }

    @Test
    void runsThatAreTooShortToTellAreInNoShare() throws Exception {
        String html =
                report("<set attribute=\"@duration\" value=\"2\"/><set attribute=\"robot/@speed\" value=\"0.2 0.3\"/>");
        assertTrue(html.contains("<p>Undecided runs (8) ended before their verdict was known"), "2 s are no lap");
        assertTrue(html.contains("A greater @duration in the plan decides more runs."), "what helps");
        assertTrue(html.contains("one in twenty is in bold by chance"));
    }

    @Test
    void oneOfAThingIsSingular() throws Exception {
        String html = report("<seeds count=\"1\"/><set attribute=\"robot/@speed\" value=\"0.2 0.3\"/>");
        assertTrue(html.contains("4 of 4 runs: 2 worlds, 1 seed each, 2 combinations in each."), html);
        assertTrue(html.contains("Runs in one world are correlated"), html);
        assertTrue(html.contains("With only 2 worlds, the correlation of runs is uncertain"), html);
        assertEquals("1 pair", Html.count(1, "pair"));
    }

    @Test
    void numbersHaveThreeDigits() {
        assertEquals(
                List.of("0.00187", "-0.0000971", "0.751", "12.3", "0", "&ndash;"),
                DoubleStream.of(0.001871, -0.00009714, 0.7513, 12.34, 0, Double.NaN)
                        .mapToObj(Html::number)
                        .toList());
    }

    /** Otherwise 199 of 200 would look like all. */
    @Test
    void aShareBetweenNinetyAndAHundredPerCentHasADecimal() {
        assertEquals(
                List.of("0", "13", "90", "90.1", "99.9", "100"),
                DoubleStream.of(0, 0.125, 0.9, 0.901, 0.999, 1)
                        .mapToObj(share -> Html.percent(share).replace("&thinsp;%", ""))
                        .toList());
    }

    /** The colour is the deeper the further the share is from a half, at most 0.45. */
    @Test
    void aCellHasItsShareAndAColourThatSaysWhetherItIsMoreThanAHalf() {
        Interval interval = new Interval(0.1, 0.95);
        String most = Html.survivalCell(new Survival(9, 10, interval));
        assertTrue(most.startsWith("<td style=\"background:rgba(0,150,160,0.36)\"><b>90&thinsp;%</b><svg"), most);
        assertTrue(most.endsWith("<small>10&ndash;95.0; n 10</small></td>"), most);
        String few = Html.survivalCell(new Survival(2, 10, interval));
        assertTrue(few.startsWith("<td style=\"background:rgba(225,110,0,0.27)\"><b>20&thinsp;%</b>"), few);
        Survival none = new Survival(0, 0, new Interval(0, 1));
        assertEquals("<td class=\"empty\">&ndash;</td>", Html.survivalCell(none));
        assertEquals("&ndash;", Html.survival(none));
    }

    @Test
    void onlyAllRunsAreAHundredPerCent() {
        assertEquals("99.9", Survival.percentText(2939 / 2940.0));
        assertEquals("99.9", Survival.percentText(0.99999));
        assertEquals("100", Survival.percentText(1));
    }

    @Test
    void aPrintedIntervalContainsItsShare() {
        int n = 10_000;
        for (int successes = 0; successes <= n; successes++) {
            Survival survival = new Survival(successes, n, Interval.wilson(successes, n));
            double share = Double.parseDouble(Survival.percentText(survival.share()));
            String low = Survival.percentText(survival.interval().low());
            String high = Survival.percentText(survival.interval().high());
            assertTrue(Double.parseDouble(low) <= share && share <= Double.parseDouble(high), low + " to " + high);
            if (successes % 100 == 0) {
                String range = "<small>" + low + "&ndash;" + high + "; n " + n + "</small>";
                assertTrue(Html.survival(survival).contains(range), range);
            }
        }
    }

    @Test
    void theTableHasOneRowForEachPairOfKinds() throws Exception {
        report(
                """
                <faults><fault kind="off stuck" sensor="any of front left rear right" at="1..3"/></faults>
                <faults name="second"><fault kind="off" sensor="any of rear-left front-right" at="1..3"/></faults>
                """);
        List<String> sums = new CampaignReport(folder)
                .cellsCsv()
                .lines()
                .skip(1)
                .filter(row -> row.split(",")[4].equals("all"))
                .map(row -> row.split(",")[0] + "," + row.split(",")[2] + " " + row.split(",")[5])
                .toList();
        assertEquals(List.of("off,off 4", "all,all 8", "stuck,off 4"), sums);
    }

    @Test
    void thePageNeedsNothingButItself() throws Exception {
        String html = report("<set attribute=\"robot/@speed\" value=\"0.2 0.3\" name=\"speed\"/>");
        assertFalse(html.contains("<script") || html.contains("http:") || html.contains("https:"));
        assertFalse(html.contains("<link") || html.contains("<img") || html.contains("NaN"));
        assertEquals(html, new CampaignReport(folder).html(List.of()), "the same table gives the same page");
        String xml = html.replace("<!DOCTYPE html>", "")
                .replaceAll("<meta[^>]*>|<br>", "")
                .replaceAll("&(ndash|thinsp);", " ")
                .replaceAll("(?s)<style>.*?</style>", "");
        DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(new InputSource(new StringReader(xml)));
    }

    /**
     * The first level of the plan is the one that the others are compared with, also after a spreadsheet has sorted.
     */
    @Test
    void theOrderOfTheRowsDoesNotMatter() throws Exception {
        String html = report("<set attribute=\"controller/@distance\" value=\"0.3 0.25\"/>");
        assertTrue(html.contains("difference to 0.3"), html);
        Path table = folder.resolve("runs.csv");
        List<String> lines = new ArrayList<>(Files.readAllLines(table));
        Collections.reverse(lines.subList(1, lines.size()));
        Files.write(table, lines);
        assertEquals(html, new CampaignReport(folder).html(List.of()));
    }

    @Test
    void anUnfinishedCampaignIsReportedAsFarAsItHasCome() throws Exception {
        report("<set attribute=\"robot/@speed\" value=\"0.2 0.3\"/>");
        List<String> rows = Files.readAllLines(folder.resolve("runs.csv"));
        Files.writeString(
                folder.resolve("runs.csv"),
                rows.stream().limit(4).collect(Collectors.joining("\n")) + "\n"
                        + rows.get(4).substring(0, 20));
        CampaignReport report = new CampaignReport(folder);
        assertEquals(3, report.runCount());
        assertTrue(report.html(List.of()).contains("3 of 8 runs"));
    }

    /** An interval depends on the worlds that have runs, not on those of the plan. */
    @Test
    void theWorldsOfAnUnfinishedCampaignAreThoseWithRuns() throws Exception {
        String elements = IntStream.range(0, 12)
                .mapToObj(i -> "<scenario file=\"" + i + ".xml\"/>")
                .collect(Collectors.joining("", "<worlds>", "</worlds>"));
        String few = "the correlation of runs is uncertain, which makes intervals wider.";
        assertFalse(reportOf(elements).contains(few));
        Path table = folder.resolve("runs.csv");
        List<String> rows = Files.readAllLines(table);
        Files.write(table, rows.subList(0, 3));
        assertTrue(new CampaignReport(folder).html(List.of()).contains("With only 2 worlds, " + few));
        Files.write(table, rows.subList(0, 2));
        assertTrue(new CampaignReport(folder).html(List.of()).contains("With only 1 world, " + few));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
                    run         | x2    | run is "x2"; expected a whole number
                    outcome     | flown | outcome is "flown"; expected one of collided, lost, stopped, undecided, carried_on, broken
                    coverage    | abc   | coverage is "abc"; expected a number from 0 to 1 or nothing
                    coverage    | 1.5   | coverage is "1.5"; expected a number from 0 to 1 or nothing
                    laps        | -1    | laps is "-1"; expected a number of at least 0 or nothing
                    trajectory_hash | zz | trajectory_hash is "zz"; expected 16 of the digits 0 to 9 and a to f
                    wall_share  | NaN   | wall_share is "NaN"; expected a number or nothing
                    simulated_s | 6,0   | simulated_s is "6,0"; expected a number from 0 to 10000000
                    simulated_s | -1    | simulated_s is "-1"; expected a number from 0 to 10000000
                    simulated_s | 1E8   | simulated_s is "1E8"; expected a number from 0 to 10000000
                    carried_on  | 1.0   | carried_on is "1.0"; expected 0, 1 or nothing
                    collided    | 0.0   | collided is "0.0"; expected 0, 1 or nothing
                    """)
    void aDamagedTableIsRefusedInOneSentenceAndContinuedWithoutTheWrongRows(String column, String value, String problem)
            throws Exception {
        String elements = "<set attribute=\"robot/@speed\" value=\"0.2 0.3\"/>";
        report(elements);
        Path table = folder.resolve("runs.csv");
        String good = Files.readString(table);
        List<String> lines = new ArrayList<>(good.lines().toList());
        List<String> cells = Csv.cells(lines.get(3));
        cells.set(Csv.cells(lines.get(0)).indexOf(column), value);
        lines.set(3, Csv.row(cells).strip());
        Files.write(table, lines);
        IOException refusal = assertThrows(IOException.class, () -> new CampaignReport(folder));
        assertEquals(table + ":4: " + problem, refusal.getMessage());
        IOException resumed = assertThrows(IOException.class, () -> report(elements));
        assertTrue(resumed.getMessage().startsWith(table + ":4: " + column + " is "), resumed.getMessage());
        Files.write(table, lines.subList(0, 3));
        report(elements);
        assertEquals(good, Files.readString(table));
    }

    /** Other programs write missing numbers, and whole ones in a column with gaps, in these ways. */
    @Test
    void aTableThatAnotherProgramHasSavedIsReported() throws Exception {
        report("<set attribute=\"robot/@speed\" value=\"0.2 0.3\"/>");
        Path table = folder.resolve("runs.csv");
        List<String> lines = new ArrayList<>(Files.readAllLines(table));
        List<String> names = Csv.cells(lines.get(0));
        List<String> missing = List.of("NA", "NaN", "nan", "null", "Infinity", "1e999");
        for (int i = 0; i < missing.size(); i++) {
            List<String> cells = Csv.cells(lines.get(i + 1));
            cells.set(names.indexOf("coverage"), missing.get(i));
            cells.set(names.indexOf("false_alarms"), "0.0");
            cells.set(names.indexOf("clock_start_s"), "5e-02");
            lines.set(i + 1, Csv.row(cells).strip());
        }
        Files.write(table, lines);
        String html = new CampaignReport(folder).html(List.of());
        assertTrue(html.contains("8 of 8 runs"), html);
    }

    /** A controller that breaks in difficult rooms would otherwise seem better than one that collides there. */
    @Test
    void brokenRunsAreInNoShareAndTheReportSaysSo() throws Exception {
        String elements = "<set attribute=\"robot/@speed\" value=\"0.2 0.3\"/>";
        assertFalse(report(elements).contains("Broken runs"));
        Path table = folder.resolve("runs.csv");
        List<String> lines = new ArrayList<>(Files.readAllLines(table));
        List<String> names = Csv.cells(lines.get(0));
        List<String> cells = Csv.cells(lines.get(3));
        cells.set(names.indexOf("outcome"), "broken");
        cells.set(names.indexOf("carried_on"), "");
        lines.set(3, Csv.row(cells).strip());
        Files.write(table, lines);
        String html = new CampaignReport(folder).html(List.of());
        assertTrue(html.contains("<p>Broken runs (1) have no verdict, and no share counts them."), html);
    }

    @Test
    void aRowThatLacksACellIsRefusedInOneSentence() throws Exception {
        report("<set attribute=\"robot/@speed\" value=\"0.2 0.3\"/>");
        Path table = folder.resolve("runs.csv");
        List<String> lines = new ArrayList<>(Files.readAllLines(table));
        List<String> cells = Csv.cells(lines.get(2));
        lines.set(2, Csv.row(cells.subList(0, cells.size() - 1)).strip());
        Files.write(table, lines);
        IOException refusal = assertThrows(IOException.class, () -> new CampaignReport(folder));
        assertEquals(
                table + ":3: the row has " + (cells.size() - 1) + " cells; expected " + cells.size()
                        + " like the header",
                refusal.getMessage());
    }

    /** The lines of a table that is mostly empty are not kept. */
    @Test
    void aTableOfManyEmptyLinesIsRefusedInLinearTime() throws Exception {
        report("<set attribute=\"robot/@speed\" value=\"0.2 0.3\"/>");
        Path table = folder.resolve("runs.csv");
        Files.writeString(table, Files.readString(table) + "\n".repeat(4_000_000));
        CpuTime time = CpuTime.start();
        IOException refusal = assertThrows(IOException.class, () -> new CampaignReport(folder));
        time.assertBelow(10);
        assertTrue(refusal.getMessage().startsWith(table + ":10: the row has 1 cell; expected "), refusal.getMessage());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
                    run,block        | BOMrun,block | :1:1: the header has no column "run"; expected names with commas between them
                    ,carried_on,     | ,went_on,    | :1:1: the header has no column "carried_on"; expected names with commas between them
                    ,robot_speed_m_s | ,speed       | :1:1: the header has no column "robot_speed_m_s"; expected names with commas between them
                    ,carried_on,     | ,collided,   | :1:1: the header has no column "carried_on"; expected names with commas between them
                    ,laps,           | ,run,        | :1:1: the header has the column "run" twice; expected it once
                    ,laps,           | ,coverage,   | :1:1: the header has the column "coverage" twice; expected it once
                    LF7,             | LF1,         | :9: run 1 is there twice; expected each run once
                    LF7,             | LF8,         | :9: run 8 is not in the plan; expected 0 to 7
                    """)
    void aTableWithOtherColumnsOrRunsIsRefusedInOneSentence(String found, String replacement, String problem)
            throws Exception {
        report("<set attribute=\"robot/@speed\" value=\"0.2 0.3\"/>");
        Path table = folder.resolve("runs.csv");
        String text = Files.readString(table);
        String damaged = text.replaceFirst(
                found.replace("LF", "\n"), replacement.replace("LF", "\n").replace("BOM", "\uFEFF"));
        assertFalse(damaged.equals(text), "it is there");
        Files.writeString(table, damaged);
        IOException refusal = assertThrows(IOException.class, () -> new CampaignReport(folder));
        assertEquals(table + problem, refusal.getMessage());
    }

    /** A spreadsheet may add columns without a heading. */
    @ParameterizedTest
    @ValueSource(strings = {"", "note"})
    void twoForeignColumnsOfOneNameChangeNothing(String name) throws Exception {
        String html = report("<set attribute=\"robot/@speed\" value=\"0.2 0.3\"/>");
        Path table = folder.resolve("runs.csv");
        List<String> lines = new ArrayList<>();
        int carriedOn = -1;
        for (String row : Files.readAllLines(table)) {
            List<String> cells = Csv.cells(row);
            carriedOn = carriedOn < 0 ? cells.indexOf("carried_on") : carriedOn;
            String added = lines.isEmpty() ? name : "0";
            cells.addAll(carriedOn, List.of(added, added));
            lines.add(Csv.row(cells).strip());
        }
        Files.write(table, lines);
        assertEquals(html, new CampaignReport(folder).html(List.of()));
    }

    @Test
    void aTableThatIsNoTextIsRefusedInOneSentence() throws Exception {
        report("<set attribute=\"robot/@speed\" value=\"0.2 0.3\"/>");
        Path table = folder.resolve("runs.csv");
        Files.write(table, new byte[] {(byte) 0xff, (byte) 0xfe, 0, '\n'}, StandardOpenOption.APPEND);
        IOException refusal = assertThrows(IOException.class, () -> new CampaignReport(folder));
        assertEquals(table + ": the file cannot be read as UTF-8 text", refusal.getMessage());
    }

    @Test
    void aTableWithAnEndlessLineIsRefusedInOneSentence() throws Exception {
        report("<set attribute=\"robot/@speed\" value=\"0.2 0.3\"/>");
        Path table = folder.resolve("runs.csv");
        long rows = Files.readAllLines(table).size();
        Files.writeString(table, "x".repeat(3 << 20), StandardOpenOption.APPEND);
        IOException refusal = assertThrows(IOException.class, () -> new CampaignReport(folder));
        assertEquals(table + ":" + (rows + 1) + ": the row is too long; expected at most 1 MiB", refusal.getMessage());
    }

    private static List<String> headings(String html) {
        return Pattern.compile("<h2>(.*?)</h2>")
                .matcher(html)
                .results()
                .map(found -> found.group(1))
                .toList();
    }
}
