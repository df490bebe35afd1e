package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.SamplePlan;
import faultline.scenario.xml.ScenarioException;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The table of detection delays counts the runs that could have detected their fault, and no others. */
class FaultSectionsTest {

    private static final String PLAN =
            """
            <worlds><scenario file="a.xml"/></worlds>
            <faults><healthy/><fault kind="off" sensor="front left" at="1"/></faults>
            """;

    private CampaignPlan plan;
    private final List<List<String>> lines = new ArrayList<>();

    @BeforeEach
    void readThePlan() throws ScenarioException {
        plan = SamplePlan.read(SamplePlan.text("", PLAN));
        lines.add(List.of("run", "fault_kind", "fault_sensor", "final_rung", "detection_delay_s"));
    }

    private void addRun(String sensor, String rung, String delay) {
        lines.add(List.of(Integer.toString(lines.size() - 1), sensor.isEmpty() ? "none" : "off", sensor, rung, delay));
    }

    private String delays() {
        return new FaultSections(new CampaignRuns(plan, lines)).delays();
    }

    @Test
    void aRunWithoutADiagnosisDoesNotLowerTheShareOfDetectedFaults() {
        addRun("front", "ALL", "2");
        addRun("front", "LEFT", "");
        addRun("front", "", "");
        assertTrue(
                delays().contains("<b>2.00</b><small>2.00</small><small>" + Html.percent(0.5) + "</small>"), delays());
    }

    @Test
    void aSensorThatFailsOnlyWithoutADiagnosisHasNoColumn() {
        addRun("front", "ALL", "2");
        addRun("left", "", "");
        assertTrue(delays().contains("front"), delays());
        assertFalse(delays().contains("left"), delays());
    }

    @Test
    void aHealthyRunHasNoDelay() {
        addRun("front", "ALL", "2");
        addRun("", "ALL", "");
        assertTrue(delays().contains("<small>" + Html.percent(1) + "</small>"), delays());
        assertFalse(delays().contains("<th scope=\"row\">none</th>"), delays());
    }

    /** Reads a plan with a second fault, of the left sensor, and adds the four runs of one block. */
    private FaultSections sectionsOfTwoFaults() throws ScenarioException {
        String second =
                """
                <faults name="second"><healthy/><fault kind="stuck" sensor="left" at="1"/></faults>
                """;
        plan = SamplePlan.read(SamplePlan.text("", PLAN.replace("front left", "front") + second));
        lines.clear();
        lines.add(List.of("run", "fault_kind", "fault_sensor", "second_kind", "second_sensor", "carried_on", "block"));
        lines.add(List.of("0", "none", "", "none", "", "1", "0"));
        lines.add(List.of("1", "none", "", "stuck", "left", "0", "0"));
        lines.add(List.of("2", "off", "front", "none", "", "1", "0"));
        lines.add(List.of("3", "off", "front", "stuck", "left", "0", "0"));
        return new FaultSections(new CampaignRuns(plan, lines));
    }

    @Test
    void aRunWithTheSecondFaultIsNotHealthy() throws ScenarioException {
        String matrix = sectionsOfTwoFaults().matrix();
        assertTrue(matrix.contains("<p>Healthy: <b>" + Html.percent(1) + "</b>"), matrix);
        assertTrue(matrix.contains("n 1</small>.</p>"), matrix);
    }

    @Test
    void eachLevelOfTheFirstComparedVariableHasAMatrixOfItsOwn() throws ScenarioException {
        plan = SamplePlan.read(
                SamplePlan.text("", "<set attribute=\"robot/@speed\" value=\"0.2 0.3\" name=\"speed\"/>" + PLAN));
        lines.clear();
        lines.add(List.of("run", "speed", "fault_kind", "fault_sensor", "carried_on", "block"));
        lines.add(List.of("0", "0.2", "off", "front", "1", "0"));
        lines.add(List.of("1", "0.3", "off", "front", "0", "0"));
        String matrix = new FaultSections(new CampaignRuns(plan, lines)).matrix();
        int fast = matrix.indexOf("<h3>speed 0.3</h3>");
        int slow = matrix.indexOf("<h3>speed 0.2</h3>");
        assertTrue(slow >= 0 && slow < fast, matrix);
        assertTrue(matrix.substring(slow, fast).contains("<b>" + Html.percent(1) + "</b>"), matrix);
        assertFalse(matrix.substring(slow, fast).contains("<b>" + Html.percent(0) + "</b>"), matrix);
        assertTrue(matrix.substring(fast).contains("<b>" + Html.percent(0) + "</b>"), matrix);
    }

    @Test
    void theMatrixNamesTheFactorsWhoseLevelsACellIncludes() throws ScenarioException {
        String compared = "<set attribute=\"robot/@speed\" value=\"0.2 0.3\" name=\"speed\"/>";
        String drawn = "<set attribute=\"controller/@distance\" value=\"0.2..0.3\"/>";
        String pooled = "<set attribute=\"controller/@diagnosis\" value=\"on off\"/>";
        addRun("front", "ALL", "");
        String start = "The runs of a cell are those with all levels of";
        assertTrue(matrixOf(compared + pooled + drawn + PLAN).contains(start + " controller_diagnosis.</p>"));
        assertFalse(matrixOf(compared + drawn + PLAN).contains(start));
        assertFalse(matrixOf(PLAN).contains(start));
    }

    private String matrixOf(String factors) throws ScenarioException {
        return new FaultSections(new CampaignRuns(SamplePlan.read(SamplePlan.text("", factors)), lines)).matrix();
    }

    @Test
    void theSecondFaultHasATableOfItsOwn() throws ScenarioException {
        String matrix = sectionsOfTwoFaults().matrix();
        assertTrue(matrix.contains("<th scope=\"col\">fault_kind</th><th scope=\"col\">front</th>"), matrix);
        assertTrue(matrix.contains("<th scope=\"col\">second_kind</th><th scope=\"col\">left</th>"), matrix);
        assertTrue(matrix.contains("<th scope=\"row\">stuck</th><td"), matrix);
        assertTrue(matrix.contains("Healthy runs have none."), matrix);
    }

    @Test
    void theTableEndsWithARowOfAllFaults() {
        addRun("front", "ALL", "2");
        addRun("left", "ALL", "");
        String half = "<small>" + Html.percent(0.5) + "</small>";
        Pattern last = Pattern.compile(
                "<th scope=\"row\">all faults</th><td>.*" + Html.percent(1) + ".*</td><td>&ndash;</td><td>.*" + half);
        assertTrue(last.matcher(delays()).find(), delays());
    }

    @Test
    void aFaultWithALabelHasARowOfThatName() throws ScenarioException {
        plan = SamplePlan.read(SamplePlan.text("", PLAN.replace("kind=\"off\"", "label=\"cut\" kind=\"off\"")));
        lines.clear();
        lines.add(List.of("run", "block", "fault_kind", "fault_sensor", "fault_label", "carried_on"));
        lines.add(List.of("0", "0", "off", "front", "cut", "1"));
        String matrix = new FaultSections(new CampaignRuns(plan, lines)).matrix();
        assertTrue(matrix.contains("<th scope=\"row\">cut</th>"), matrix);
        assertFalse(matrix.contains("<th scope=\"row\">off</th>"), matrix);
    }

    @Test
    void aGroupOfRunsIsNamedAfterAllOfItsFaults() throws ScenarioException {
        sectionsOfTwoFaults();
        CampaignRuns campaign = new CampaignRuns(plan, lines);
        assertEquals(
                List.of("healthy", "left stuck", "front off", "front off + left stuck"),
                campaign.rows().stream().map(campaign::faultName).toList());
    }

    /** 101 kinds of fault of a sensor each would be 10 201 cells. */
    @Test
    void ofMoreThanTenThousandCellsOnlyThoseWithRunsAreListed() {
        for (int i = 0; i < 101; i++) {
            String number = Integer.toString(i);
            lines.add(List.of(number, "kind" + i, "s" + i, "ALL", "2"));
        }
        String table = delays();
        String cell = "<td><b>2.00</b><small>2.00</small><small>" + Html.percent(1) + "</small></td></tr>";
        assertTrue(table.contains("<th scope=\"row\">kind7</th><td>s7</td>" + cell), table);
        assertTrue(table.contains("<th scope=\"row\">kind7</th><td>all</td>" + cell), table);
        assertTrue(table.contains("<th scope=\"row\">all faults</th><td>s7</td>" + cell), table);
        assertTrue(table.contains("<th scope=\"row\">all faults</th><td>all</td>" + cell), table);
        assertEquals(1 + 101 + 101 + 102, table.split("<tr>", -1).length - 1);
    }

    @Test
    void runsWithoutAnyDelayHaveNoTable() {
        addRun("front", "ALL", "");
        assertEquals("", delays());
    }
}
