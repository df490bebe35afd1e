package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.SamplePlan;
import faultline.scenario.xml.ScenarioException;
import java.util.ArrayList;
import java.util.List;
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
        return new FaultSections(new RunData(plan, lines)).delays();
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

    @Test
    void runsWithoutAnyDelayHaveNoTable() {
        addRun("front", "ALL", "");
        assertEquals("", delays());
    }
}
