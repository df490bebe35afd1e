package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.Column;
import faultline.campaign.plan.PlannedRun;
import faultline.campaign.plan.SamplePlan;
import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.CarryOnMetrics;
import faultline.engine.metrics.DiagnosisMetrics;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.scenario.RunSummary;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;

class ResultColumnsTest {

    @Test
    void everyColumnThatIsNotVariedIsReserved() throws Exception {
        CampaignPlan plan = SamplePlan.read(SamplePlan.text("", "<worlds><scenario file=\"room.xml\"/></worlds>"));
        Set<String> names = new HashSet<>();
        ResultColumns.of(plan).forEach(column -> names.add(column.name()));
        assertEquals(CampaignPlan.RESERVED_COLUMNS, names);
    }

    @Test
    void namesAreInLowerSnakeAndEndWithTheirUnits() throws Exception {
        CampaignPlan plan = SamplePlan.read(SamplePlan.text(
                "",
                "<worlds><scenario file=\"room.xml\"/></worlds><set attribute=\"robot/@turnRate\" value=\"30 60\"/>"
                        + "<faults><fault sensor=\"front\" kind=\"off\" at=\"1\"/></faults><masks sensors=\"left\"/>"));
        List<Column> columns = ResultColumns.of(plan);
        for (Column column : columns) {
            String suffix = column.unit().replace('/', '_').toLowerCase(Locale.ROOT);
            assertTrue(column.name().matches("[a-z][a-z0-9_]*"), column.name());
            assertTrue(column.name().endsWith(suffix), column.name() + " is in " + column.unit());
            assertTrue(!column.meaning().isBlank(), column.name());
        }
    }

    @Test
    void theTimeOfALapIncludesItsCorners() throws Exception {
        CampaignPlan plan = SamplePlan.read(SamplePlan.text("", "<worlds><scenario file=\"room.xml\"/></worlds>"));
        Column carriedOn = ResultColumns.of(plan).stream()
                .filter(column -> column.name().equals("carried_on"))
                .findFirst()
                .orElseThrow();
        assertTrue(carriedOn.meaning().contains("10 s for its corners"), carriedOn.meaning());
    }

    private static Map<String, String> cells(CampaignPlan plan, String row) {
        List<String> names = Csv.cells(ResultColumns.header(plan).strip());
        List<String> cells = Csv.cells(row.strip());
        assertEquals(names.size(), cells.size());
        Map<String, String> byName = new LinkedHashMap<>();
        names.forEach(name -> byName.put(name, cells.get(byName.size())));
        return byName;
    }

    /** A run of a plan with its measures, and its row by the names of the columns. */
    private record MeasuredRun(
            RunResult result, CarryOnMetrics carry, DiagnosisMetrics diagnosis, Map<String, String> cells) {

        static MeasuredRun of(CampaignPlan plan, int index) throws Exception {
            PlannedRun run = plan.run(index);
            SimulationSetup setup = plan.scenario(run).setup();
            CarryOnMetrics carry = new CarryOnMetrics(setup, CarryOnMetrics.circuit(setup));
            DiagnosisMetrics diagnosis = new DiagnosisMetrics(setup);
            RunResult result = HeadlessRun.run(setup, ControllerMode.DIRECT, List.of(carry, diagnosis));
            String row = ResultColumns.row(run, result, carry, diagnosis);
            return new MeasuredRun(result, carry, diagnosis, ResultColumnsTest.cells(plan, row));
        }
    }

    private static CampaignPlan twoSeedsAndTwoFaults() throws Exception {
        return SamplePlan.read(
                SamplePlan.text(
                        "",
                        """
                <worlds><scenario file="room.xml"/></worlds><seeds first="7" count="2"/>
                <set attribute="@duration" value="60"/>
                <faults><fault sensor="front" kind="off" at="1"/><fault sensor="left" kind="stuck" at="20"/></faults>
                """));
    }

    /** No two of the numbers are alike, so that one in the column of another would be noticed. */
    @Test
    void everyCellIsWhatItsColumnIsNamedAfter() throws Exception {
        CampaignPlan plan = twoSeedsAndTwoFaults();
        MeasuredRun run = MeasuredRun.of(plan, 3);
        RunResult result = run.result();
        CarryOnMetrics carry = run.carry();
        DiagnosisMetrics diagnosis = run.diagnosis();
        Map<String, String> cells = run.cells();

        assertEquals(List.of("3", "1", "room", "8"), List.copyOf(cells.values()).subList(0, 4));
        Map<String, OptionalDouble> numbers = Map.of(
                "wall_share", carry.share(),
                "laps", carry.laps(),
                "clock_start_s", carry.clockStart(),
                "coverage", result.coverage(),
                "distance_rms_m", result.distanceRms(),
                "follow_rms_m", result.followRms(),
                "detection_delay_s", diagnosis.detectionDelay(),
                "detection_view_s", diagnosis.secondsInView(),
                "detection_error_m", diagnosis.errorBeforeDetection(),
                "simulated_s", OptionalDouble.of(result.simulatedSeconds()));
        Map<String, Integer> digits = Map.of(
                "wall_share", 4,
                "coverage", 4,
                "detection_error_m", 4,
                "distance_rms_m", 6,
                "follow_rms_m", 6,
                "simulated_s", 9);
        numbers.forEach((name, number) ->
                assertEquals(rounded(number.orElseThrow(), digits.getOrDefault(name, 3)), cells.get(name), name));
        assertEquals(
                numbers.size(),
                numbers.keySet().stream().map(cells::get).distinct().count(),
                cells::toString);
        assertEquals(RunSummary.formatHash(result), cells.get("trajectory_hash"));
        assertEquals(diagnosis.rung(), cells.get("final_rung"));
        assertEquals("0", cells.get("false_alarms"));
        assertEquals("", cells.get("failure"));
    }

    @Test
    void aRunThatCarriedOnIsOneAndOneThatDidNotIsZero() throws Exception {
        CampaignPlan plan = SamplePlan.read(
                SamplePlan.text(
                        "",
                        """
                <worlds><scenario file="room.xml"/></worlds>
                <set attribute="@duration" value="60"/>
                <set attribute="controller/@diagnosis" value="off"/>
                <faults><healthy/><fault sensor="front" kind="stuck" value="0.9" at="1"/></faults>
                """));
        Map<String, String> healthy = MeasuredRun.of(plan, 0).cells();
        assertEquals(List.of("carried_on", "1"), List.of(healthy.get("outcome"), healthy.get("carried_on")));
        Map<String, String> faulty = MeasuredRun.of(plan, 1).cells();
        assertEquals(List.of("collided", "0"), List.of(faulty.get("outcome"), faulty.get("carried_on")));
    }

    private static String rounded(double number, int digits) {
        return BigDecimal.valueOf(number)
                .setScale(digits, RoundingMode.HALF_UP)
                .stripTrailingZeros()
                .toPlainString();
    }

    @Test
    void whatAShortRunWithoutADiagnosisDoesNotKnowIsEmpty() throws Exception {
        CampaignPlan plan = SamplePlan.read(
                SamplePlan.text(
                        "",
                        """
                <worlds><scenario file="room.xml"/></worlds>
                <set attribute="@tick" value="0.003"/><set attribute="@duration" value="0.5"/>
                <set attribute="controller/@diagnosis" value="off"/>
                """));
        Map<String, String> cells = MeasuredRun.of(plan, 0).cells();
        assertEquals("undecided", cells.get("outcome"));
        assertEquals("0", cells.get("collided"));
        assertEquals("0.501", cells.get("simulated_s"));
        for (String name : List.of("carried_on", "clock_start_s", "false_alarms", "final_rung", "detection_delay_s")) {
            assertEquals("", cells.get(name), name);
        }
    }

    @Test
    void aBrokenRunHasOnlyAnOutcomeAndTheStartOfItsFailure() throws Exception {
        CampaignPlan plan = twoSeedsAndTwoFaults();
        Map<String, String> cells = cells(plan, ResultColumns.brokenRow(plan.run(2), "x".repeat(1000)));
        assertEquals(List.of("2", "1", "room", "8"), List.copyOf(cells.values()).subList(0, 4));
        assertEquals("broken", cells.remove("outcome"));
        assertEquals("x".repeat(200), cells.remove("failure"));
        CampaignPlan.RUN_COLUMNS.forEach(column -> cells.remove(column.name()));
        plan.factorColumns().forEach(column -> cells.remove(column.name()));
        assertEquals(Set.of(""), Set.copyOf(cells.values()));
    }

    @Test
    void columnsWithFlagsSayThatBrokenRunsHaveNone() throws Exception {
        List<String> meanings = ResultColumns.of(twoSeedsAndTwoFaults()).stream()
                .filter(column -> List.of("carried_on", "collided").contains(column.name()))
                .map(Column::meaning)
                .toList();
        assertEquals(2, meanings.size());
        meanings.forEach(meaning -> assertTrue(meaning.matches(".*, empty if .*broken"), meaning));
    }
}
