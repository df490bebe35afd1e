package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.SamplePlan;
import faultline.scenario.xml.ScenarioException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;

/** The sections of a report that compare levels and divide the ranges of drawn numbers. */
class VariantSectionsTest {

    private static final String ONE_WORLD = "<worlds><scenario file=\"a.xml\"/></worlds><seeds count=\"20\"/>";

    private final List<List<String>> lines = new ArrayList<>();

    private static CampaignPlan plan(String factors) throws ScenarioException {
        return SamplePlan.read(SamplePlan.text("", ONE_WORLD + factors));
    }

    private void addRun(int block, String value, String carriedOn) {
        lines.add(List.of(Integer.toString(lines.size() - 1), Integer.toString(block), "a", value, carriedOn));
    }

    /** Returns the comparison of two speeds, with which the robot carries on in some of ten blocks each. */
    private String comparison(int slow, int fast) throws ScenarioException {
        lines.clear();
        lines.add(List.of("run", "block", "world", "speed", "carried_on"));
        for (int block = 0; block < 10; block++) {
            addRun(block, "0.2", block < slow ? "1" : "0");
            addRun(block, "0.3", block < fast ? "1" : "0");
        }
        CampaignPlan plan = plan("<set attribute=\"robot/@speed\" value=\"0.2 0.3\" name=\"speed\"/>");
        return new VariantSections(new RunData(plan, lines)).comparisons();
    }

    @Test
    void aDifferenceIsBoldIfItsIntervalDoesNotContainZero() throws ScenarioException {
        assertTrue(comparison(10, 0).contains("<b>-100</b><br><small>-100 to -"), comparison(10, 0));
        assertTrue(comparison(0, 10).contains("<b>+100</b><br><small>+"), comparison(0, 10));
        assertTrue(comparison(5, 6).contains("<td>+10<br><small>-"), comparison(5, 6));
        assertFalse(comparison(5, 6).contains("<b>+10</b>"), comparison(5, 6));
        assertTrue(comparison(5, 5).contains("<td>0<br><small>-"), comparison(5, 5));
    }

    /** Of ten parts of the range from 0 to 0.8, runs are in the first two; the greatest value is in the last one. */
    @Test
    void theGreatestValueBelongsToTheLastPartOfItsRange() throws ScenarioException {
        lines.add(List.of("run", "block", "world", "fault_value", "carried_on"));
        for (int block = 0; block < 13; block++) {
            addRun(block, String.format(Locale.ROOT, "0.%02d", block), "1");
        }
        addRun(13, "0.8", "0");
        CampaignPlan plan = plan("<faults><fault kind=\"stuck\" sensor=\"front\" value=\"0..0.8\" at=\"1\"/></faults>");
        String chart = new VariantSections(new RunData(plan, lines)).responses();
        assertEquals(3, chart.split("<circle ", -1).length - 1, chart);
    }
}
