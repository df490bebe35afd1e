package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.Column;
import faultline.campaign.plan.SamplePlan;
import faultline.campaign.run.Csv;
import faultline.scenario.xml.ScenarioException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The numbers of the cells of a campaign; all expected ones can be counted by hand. */
class CellTableTest {

    private static final String PLAN =
            """
            <worlds><scenario file="a.xml"/></worlds>
            <seeds count="10"/>
            <faults><healthy/><fault kind="off" sensor="front" at="1"/></faults>
            """;

    private CampaignPlan plan;
    private final List<List<String>> lines = new ArrayList<>();

    @BeforeEach
    void readThePlan() throws ScenarioException {
        plan = SamplePlan.read(SamplePlan.text("", PLAN));
        lines.add(List.of(
                "run",
                "block",
                "world",
                "fault_kind",
                "fault_sensor",
                "outcome",
                "carried_on",
                "collided",
                "coverage",
                "distance_rms_m",
                "detection_delay_s",
                "false_alarms",
                "detection_view_s",
                "detection_error_m"));
    }

    private void addRun(String outcome, String carriedOn, String collided, String coverage, String delay, int alarms) {
        addRun(Integer.toString(lines.size() - 1), outcome, carriedOn, collided, coverage, delay, alarms);
    }

    private void addRun(
            String block,
            String outcome,
            String carriedOn,
            String collided,
            String coverage,
            String delay,
            int alarms) {
        lines.add(List.of(
                Integer.toString(lines.size() - 1),
                block,
                "a",
                "off",
                "front",
                outcome,
                carriedOn,
                collided,
                coverage,
                "",
                delay,
                Integer.toString(alarms),
                delay.isEmpty() ? "" : "0.25",
                delay.isEmpty() ? "" : "0.5"));
    }

    /** Seven of nine runs with a verdict carry on; the delays are 1 to 10 s. */
    private void addTenRuns() {
        addRun("collided", "0", "1", "0.5", "10", 0);
        addRun("lost", "0", "0", "0.1", "1", 2);
        addRun("undecided", "", "0", "", "2", 1);
        for (int delay = 3; delay <= 9; delay++) {
            addRun("carried_on", "1", "0", "0.9", Integer.toString(delay), 0);
        }
    }

    private CampaignRuns campaign() {
        return new CampaignRuns(plan, lines);
    }

    /** The interval is Wilson's for 7 of 9; the fifth of ten delays is their median, the ninth their 90 % quantile. */
    @Test
    void aRowCountsTheRunsOfItsCell() {
        addTenRuns();
        List<String> rows = new CellTable(campaign()).csv().lines().toList();
        assertEquals(
                "fault_kind,fault_sensor,final_rung,runs,carried_on,share,share_low,share_high,collided,lost,stopped,"
                        + "undecided,broken,detected,delay_median_s,delay_90_s,false_alarm_runs,view_median_s,"
                        + "error_median_m",
                rows.get(0));
        String numbers = "all,10,7,0.7778,0.4526,0.9368,1,1,0,1,0,10,5.0000,9.0000,2,0.2500,0.5000";
        assertEquals(
                List.of("off,front," + numbers, "off,all," + numbers, "all,front," + numbers, "all,all," + numbers),
                rows.subList(1, rows.size()));
    }

    @Test
    void eachRungHasARowForAllFaultsAndOneForHealthyRuns() {
        lines.clear();
        lines.add(List.of("run", "block", "fault_kind", "fault_sensor", "final_rung", "outcome", "carried_on"));
        lines.add(List.of("0", "0", "none", "", "ALL", "carried_on", "1"));
        lines.add(List.of("1", "0", "off", "front", "THREE", "carried_on", "1"));
        lines.add(List.of("2", "1", "off", "front", "THREE", "lost", "0"));
        lines.add(List.of("3", "2", "off", "front", "", "lost", "0"));
        List<String> rungs = new CellTable(campaign())
                .csv()
                .lines()
                .skip(1)
                .map(row -> String.join(",", List.of(row.split(",")).subList(0, 5)))
                .filter(row -> !row.split(",")[2].equals("all"))
                .toList();
        assertEquals(List.of("none,,ALL,1,1", "all,all,THREE,2,1"), rungs);
    }

    /**
     * Returns the labels and the numbers of runs of all rows, given a plan's faults and the labels of two faulty runs.
     */
    private List<String> cellsOf(String faults, List<String> first, List<String> second) throws ScenarioException {
        plan = SamplePlan.read(
                SamplePlan.text("", "<worlds><scenario file=\"a.xml\"/></worlds>" + faults),
                SamplePlan.ROOM.replace(
                        "y=\"1.2\"/>",
                        "y=\"1.2\"><sensor id=\"all\" x=\"0.1\" y=\"0\" bearing=\"0\"/>"
                                + "<sensor id=\"left\" x=\"0\" y=\"0.1\" bearing=\"90\"/></robot>"));
        lines.clear();
        lines.add(List.of("run", "block", "world", "fault_kind", "fault_sensor", "fault_label", "carried_on"));
        lines.add(List.of("0", "0", "a", "none", "", "none", "1"));
        lines.add(List.of("1", "0", "a", "off", first.get(0), first.get(1), "0"));
        lines.add(List.of("2", "0", "a", "off", second.get(0), second.get(1), "1"));
        return new CellTable(campaign())
                .csv()
                .lines()
                .skip(1)
                .map(row -> String.join(",", Csv.cells(row).subList(0, 4)))
                .toList();
    }

    @Test
    void aFaultThatIsLabelledAllIsNoTotal() throws ScenarioException {
        String faults =
                """
                <faults>
                  <healthy/>
                  <fault kind="off" sensor="left" at="1" label="all"/>
                  <fault kind="off" sensor="left" at="2" label="&quot;all&quot;"/>
                </faults>
                """;
        assertEquals(
                List.of(
                        "none,,all,1",
                        "\"all\",left,all,1",
                        "\"all\",all,all,1",
                        "all,left,all,2",
                        "all,all,all,2",
                        "\"\"all\"\",left,all,1",
                        "\"\"all\"\",all,all,1"),
                cellsOf(faults, List.of("left", "all"), List.of("left", "\"all\"")));
    }

    @Test
    void aSensorThatIsCalledAllIsNoTotal() throws ScenarioException {
        String faults =
                """
                <faults><healthy/><fault kind="off" sensor="all left" at="1" label="out"/></faults>
                """;
        assertEquals(
                List.of(
                        "none,,all,1",
                        "out,\"all\",all,1",
                        "out,all,all,2",
                        "all,\"all\",all,1",
                        "all,all,all,2",
                        "out,left,all,1",
                        "all,left,all,1"),
                cellsOf(faults, List.of("all", "out"), List.of("left", "out")));
    }

    @Test
    void aCellHasTheMeansOfThoseRunsThatHaveNumbers() {
        addTenRuns();
        CampaignCell cell = CampaignCell.allOf(plan, lines).get(0);
        assertEquals(List.of("off", "front"), cell.labels());
        assertEquals(IntStream.range(0, 10).mapToObj(run -> (long) run).toList(), cell.runs());
        assertEquals(7.0 / 9, cell.carriedOn().share());
        assertEquals(9.0 / 10, cell.withoutContact().share());
        assertEquals((0.5 + 0.1 + 7 * 0.9) / 9, cell.coverageOrNaN(), 1e-12);
        assertTrue(Double.isNaN(cell.distanceRmsOrNaN()));
    }

    /** Three blocks of two equal runs are worth three runs; see {@link ClusteredSampleTest}. */
    @Test
    void theIntervalCountsRunsOfOneBlockThatAgreeAsFewerRuns() {
        for (String block : List.of("0", "1", "2")) {
            String carriedOn = block.equals("2") ? "0" : "1";
            addRun(block, "finished", carriedOn, "0", "", "", 0);
            addRun(block, "finished", carriedOn, "0", "", "", 0);
        }
        Survival survival = Survival.of(campaign().rows());
        Interval three = Interval.wilson(2, 3);
        assertEquals(4 / 6.0, survival.share());
        assertEquals(three.low(), survival.interval().low(), 1e-12);
        assertEquals(three.high(), survival.interval().high(), 1e-12);
    }

    @Test
    void withoutAVerdictEveryShareIsPossible() {
        addRun("undecided", "", "0", "", "", 0);
        assertEquals(
                new Survival(0, 0, new Interval(0, 1)), Survival.of(campaign().rows()));
        assertEquals(0, Survival.of(campaign().rows()).share());
    }

    /** Other programs write a missing number in these ways. */
    @ParameterizedTest
    @ValueSource(strings = {"", "NA", "NaN", "nan", "Infinity", "-Infinity", "1e999"})
    void aNumberThatIsNotFiniteIsMissing(String text) {
        addRun("carried_on", "1", "0", text, text, 0);
        addRun("carried_on", "1", "0", "0.5", "3", 0);
        assertArrayEquals(new double[] {0.5}, CampaignRuns.values(campaign().rows(), "coverage"));
        assertArrayEquals(new double[] {3}, CampaignRuns.values(campaign().rows(), FaultSections.DELAY));
        String charts = new VariantSections(campaign()).distributions();
        assertTrue(charts.contains("coverage, n 1"), charts);
        assertFalse(charts.contains("laps"), "no run has any");
    }

    /** A variant may have the name of a total, because variants are never summed. */
    @Test
    void eachLevelHasCellsOfItsOwn() throws ScenarioException {
        plan = SamplePlan.read(SamplePlan.text(
                "",
                "<variants><variant name=\"all\"/><variant name=\"fast\">"
                        + "<set attribute=\"robot/@speed\" value=\"0.3\"/></variant></variants>" + PLAN));
        lines.clear();
        lines.add(List.of("run", "block", "world", "variant", "fault_kind", "fault_sensor", "carried_on"));
        lines.add(List.of("0", "0", "a", "all", "off", "front", "1"));
        lines.add(List.of("1", "0", "a", "fast", "off", "front", "0"));
        CellTable table = new CellTable(campaign());
        assertEquals(List.of("variant", "fault_kind", "fault_sensor"), table.labelColumns());
        List<String> all = List.of("all,off,front,all,1,1", "all,off,all,all,1,1", "all,all,front,all,1,1");
        assertEquals(
                all,
                table.csv()
                        .lines()
                        .skip(1)
                        .limit(3)
                        .map(CellTableTest::firstSix)
                        .toList());
        assertEquals(
                List.of("fast,off,front,all,1,0"),
                table.csv()
                        .lines()
                        .skip(5)
                        .limit(1)
                        .map(CellTableTest::firstSix)
                        .toList());
        assertFalse(table.isSum(List.of("all", "off", "front")));
        assertTrue(table.isSum(List.of("fast", "all", "front")));
        assertTrue(table.isSum(List.of("fast", "off", "all")));
    }

    private static String firstSix(String row) {
        return String.join(",", Csv.cells(row).subList(0, 6));
    }

    /** Up to twelve levels are compared; more are drawn as a range, as are numbers that are drawn. */
    @ParameterizedTest
    @CsvSource({"1, 0, 0", "2, 1, 0", "12, 1, 0", "13, 0, 1"})
    void aVariableIsComparedOrContinuous(int levels, int compared, int continuous) throws ScenarioException {
        List<String> values =
                IntStream.range(0, levels).mapToObj(i -> "0." + (10 + i)).toList();
        plan = SamplePlan.read(SamplePlan.text(
                "",
                PLAN.replace("kind=\"off\"", "kind=\"off\" label=\"out\"")
                        .replace(
                                "<faults>",
                                "<set attribute=\"robot/@speed\" name=\"speed\" value=\"" + String.join(" ", values)
                                        + "\"/><faults>")));
        lines.clear();
        lines.add(List.of("run", "block", "world", "speed", "fault_label"));
        values.forEach(value -> lines.add(List.of("0", "0", "a", value, "label " + value)));
        lines.add(List.of("0", "0", "a", "", ""));
        assertEquals(compared, campaign().comparedFactors().size());
        assertEquals(
                continuous == 1 ? List.of("speed") : List.of(),
                campaign().continuousColumns().stream().map(Column::name).toList());
    }

    /** Each world is worth one run, because all runs of a world agree. */
    @Test
    void theRunsOfEachOfTwoWorldsAreACluster() throws ScenarioException {
        plan = SamplePlan.read(SamplePlan.text("", PLAN.replace("</worlds>", "<scenario file=\"b.xml\"/></worlds>")));
        lines.clear();
        lines.add(List.of("run", "block", "world", "fault_kind", "fault_sensor", "carried_on"));
        for (int run = 0; run < 4; run++) {
            String block = Integer.toString(run);
            lines.add(List.of(block, block, run < 2 ? "a" : "b", "off", "front", run < 2 ? "1" : "0"));
        }
        Interval expected = Interval.wilson(1, 2);
        Interval interval = Survival.of(campaign().rows()).interval();
        assertEquals(expected.low(), interval.low(), 1e-12);
        assertEquals(expected.high(), interval.high(), 1e-12);
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "0.004, 0", "0.126, 13", "0.9, 90", "0.906, 90.6", "0.9994, 99.9", "0.9999, 99.9", "1, 100"})
    void aShareInPercentIsAHundredForAllRunsOnly(double share, String text) {
        assertEquals(text, Survival.percentText(share));
    }
}
