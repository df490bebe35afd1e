package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.SamplePlan;
import faultline.scenario.xml.ScenarioException;
import java.util.ArrayList;
import java.util.Arrays;
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

    private void addRun(int block, String value, String carriedOn, String... numbers) {
        List<String> cells = new ArrayList<>(
                List.of(Integer.toString(lines.size() - 1), Integer.toString(block), "a", value, carriedOn));
        cells.addAll(List.of(numbers));
        lines.add(cells);
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
        return new VariantSections(new CampaignRuns(plan, lines)).comparisons();
    }

    @Test
    void aDifferenceIsBoldIfItsIntervalDoesNotContainZero() throws ScenarioException {
        assertTrue(comparison(10, 0).contains("<b>-100</b><br><small>-100 to -"), comparison(10, 0));
        assertTrue(comparison(0, 10).contains("<b>+100</b><br><small>+"), comparison(0, 10));
        assertTrue(comparison(5, 6).contains("<td>+10<br><small>-"), comparison(5, 6));
        assertFalse(comparison(5, 6).contains("<b>+10</b>"), comparison(5, 6));
        assertTrue(comparison(5, 5).contains("<td>0<br><small>-"), comparison(5, 5));
        String header = "<th scope=\"col\">runs</th><th scope=\"col\">0.2</th><th scope=\"col\">0.3</th>"
                + "<th scope=\"col\">difference</th>";
        assertTrue(comparison(5, 6).contains(header), comparison(5, 6));
        assertTrue(comparison(5, 6).contains("<title>speed 0.3 less 0.2, percentage points</title>"), "a chart");
        assertTrue(comparison(5, 6).contains("Student's t over seeds and draws"), comparison(5, 6));
    }

    /** A part of a campaign may begin with any combination of levels. */
    @Test
    void aPartThatBeginsWithTheSecondLevelIsComparedWithTheFirst() throws ScenarioException {
        comparison(10, 0);
        lines.remove(1);
        CampaignPlan plan = plan("<set attribute=\"robot/@speed\" value=\"0.2 0.3\" name=\"speed\"/>");
        String part = new VariantSections(new CampaignRuns(plan, lines)).comparisons();
        assertTrue(part.contains("<b>-100</b>"), part);
        assertTrue(part.contains("<title>speed 0.3 less 0.2, percentage points</title>"), part);
    }

    @Test
    void aLevelWithoutOthersIsNotCompared() throws ScenarioException {
        lines.add(List.of("run", "block", "world", "speed", "carried_on"));
        addRun(0, "0.2", "1");
        CampaignPlan plan = plan("<set attribute=\"robot/@speed\" value=\"0.2 0.3\" name=\"speed\"/>");
        assertEquals("", new VariantSections(new CampaignRuns(plan, lines)).comparisons());
    }

    @Test
    void aFaultThatHasOnlyRunsOfOneLevelHasNoDifference() throws ScenarioException {
        CampaignPlan plan = plan("<set attribute=\"robot/@speed\" value=\"0.2 0.3\" name=\"speed\"/>"
                + "<faults><fault kind=\"off\" sensor=\"front left\" at=\"1\"/></faults>");
        List<String> header = new ArrayList<>(List.of("run", "block", "world", "speed", "carried_on"));
        plan.factorColumns().stream().skip(1).forEach(column -> header.add(column.name()));
        lines.add(header);
        String[] front = new String[header.size() - 5];
        Arrays.fill(front, "");
        front[0] = "off";
        front[1] = "front";
        String[] left = front.clone();
        left[1] = "left";
        addRun(0, "0.2", "1", front);
        addRun(0, "0.3", "1", front);
        addRun(0, "0.2", "1", left);
        String section = new VariantSections(new CampaignRuns(plan, lines)).comparisons();
        int start = section.indexOf("<th scope=\"row\">left off</th>");
        String row = section.substring(start, section.indexOf("</tr>", start));
        assertTrue(row.endsWith("<td class=\"empty\">&ndash;</td><td>&ndash;</td>"), row);
    }

    /**
     * The differences of the coverage are 0.1 and 0.3 in turn, those of the laps 1 and -1. Half an interval is 2.262 by
     * the deviation, which is the expected distance from the mean by the square root of 10 / 9, by 1 / sqrt(10).
     */
    @Test
    void numbersAreComparedByTheirMeansAndPairedDifferences() throws ScenarioException {
        lines.add(List.of("run", "block", "world", "speed", "carried_on", "coverage", "laps"));
        for (int block = 0; block < 10; block++) {
            boolean odd = block % 2 == 1;
            addRun(block, "0.2", "1", "0.5", "2");
            addRun(block, "0.3", "1", odd ? "0.8" : "0.6", odd ? "3" : "1");
        }
        CampaignPlan plan = plan("<set attribute=\"robot/@speed\" value=\"0.2 0.3\" name=\"speed\"/>");
        String section = new VariantSections(new CampaignRuns(plan, lines)).comparisons();
        String header = "<th scope=\"col\">number</th><th scope=\"col\">0.2</th><th scope=\"col\">0.3</th>"
                + "<th scope=\"col\">difference of 0.3</th>";
        assertTrue(section.contains(header), section);
        String coverage = "<th scope=\"row\">coverage</th><td>0.5 <small>n 10</small></td>"
                + "<td>0.7 <small>n 10</small></td><td><b>+0.2</b><br><small>0.125 to 0.275; 10 pairs</small></td>";
        assertTrue(section.contains(coverage), section);
        assertTrue(section.contains("<td>0<br><small>-0.754 to 0.754; 10 pairs</small></td>"), section);
    }

    @Test
    void aDifferenceInASingleWorldHasNoInterval() throws ScenarioException {
        lines.add(List.of("run", "block", "world", "speed", "carried_on", "coverage"));
        addRun(0, "0.2", "1", "0.5");
        addRun(0, "0.3", "1", "0.8");
        CampaignPlan plan = plan("<set attribute=\"robot/@speed\" value=\"0.2 0.3\" name=\"speed\"/>");
        String section = new VariantSections(new CampaignRuns(plan, lines)).comparisons();
        assertTrue(section.contains("<td>+0.3<br><small>1 pair</small></td>"), section);
    }

    /** Of ten parts of the range from 0 to 0.8, runs are in the first two; the greatest value is in the last one. */
    @Test
    void theGreatestValueBelongsToTheLastPartOfItsRange() throws ScenarioException {
        lines.add(List.of("run", "block", "world", "fault_value", "carried_on"));
        for (int block = 0; block < 13; block++) {
            addRun(block, String.format(Locale.ROOT, "0.%02d", block), "1");
        }
        addRun(13, "0.8", "0");
        addRun(14, "", "1");
        CampaignPlan plan = plan("<faults><fault kind=\"stuck\" sensor=\"front\" value=\"0..0.8\" at=\"1\"/></faults>");
        String chart = new VariantSections(new CampaignRuns(plan, lines)).responses();
        ReportChartsTest.assertPlaces(chart, ReportChartsTest.DOT, 0.05, 1, 0.15, 1, 0.95, 0);
    }

    @Test
    void labelsDoNotDivideTheRunsOfAKind() throws ScenarioException {
        lines.add(List.of("run", "block", "world", "fault_value", "carried_on", "fault_kind", "fault_label"));
        StringBuilder faults = new StringBuilder("<faults>");
        for (int i = 10; i < 24; i++) {
            addRun(0, "0." + i, "1", "bias", "case " + i);
            faults.append("<fault label=\"case %d\" kind=\"bias\" sensor=\"front\" value=\"0.%d\" at=\"1\"/>"
                    .formatted(i, i));
        }
        String charts = new VariantSections(new CampaignRuns(plan(faults + "</faults>"), lines)).responses();
        assertEquals(2, charts.split("<title>").length, charts);
        assertTrue(charts.contains("<title>carried on over fault_value, bias</title>"), charts);
    }

    @Test
    void aPageWithManyChartsSaysHowManyAreLeftOut() throws ScenarioException {
        List<String> header = new ArrayList<>(List.of("run", "block", "world", "other", "carried_on"));
        StringBuilder faults = new StringBuilder();
        for (int i = 0; i < 103; i++) {
            header.add("f" + i + "_value");
            faults.append(
                    "<faults name=\"f%d\"><fault kind=\"stuck\" sensor=\"front\" value=\"0..0.8\" at=\"1\"/></faults>"
                            .formatted(i));
        }
        lines.add(header);
        for (int block = 0; block < 13; block++) {
            String[] numbers = new String[103];
            Arrays.fill(numbers, String.valueOf(block));
            addRun(block, "", "1", numbers);
        }
        CampaignPlan plan = plan(faults.toString());
        String section = new VariantSections(new CampaignRuns(plan, lines)).responses();
        assertTrue(
                section.contains("<p>These are the first 100 charts of 103. The other 3 are left out.</p>"), section);
        assertEquals(101, section.split("<title>").length);
    }

    /** The parts of the range from 10 to 20 s begin at whole seconds. The kind of a fault does not matter here. */
    @Test
    void aValueBetweenTwoPartsOfARangeBelongsToTheUpperOne() throws ScenarioException {
        lines.add(List.of("run", "block", "world", "fault_onset_s", "carried_on", "fault_kind"));
        for (int block = 0; block < 12; block++) {
            addRun(block, String.format(Locale.ROOT, "10.%02d", block), "1", "off");
        }
        addRun(12, "11", "0", "stuck");
        addRun(13, "20", "0", "stuck");
        addRun(14, "40", "", "stuck");
        CampaignPlan plan = plan("<faults><fault kind=\"off stuck\" sensor=\"front\" at=\"10..40\"/></faults>");
        String chart = new VariantSections(new CampaignRuns(plan, lines)).responses();
        ReportChartsTest.assertPlaces(chart, ReportChartsTest.DOT, 0.05, 1, 0.15, 0, 0.95, 0);
        assertTrue(chart.contains("<title>carried on over fault_onset_s</title>"), chart);
        assertTrue(chart.contains(">fault_onset_s (s)</text>"), chart);
    }

    @Test
    void aNumberThatIsTheSameAtBothLevelsHasNoBoldDifference() throws ScenarioException {
        lines.add(List.of("run", "block", "world", "speed", "carried_on", "coverage"));
        for (int block = 0; block < 10; block++) {
            addRun(block, "0.2", "1", "0.5");
            addRun(block, "0.3", "1", "0.5");
        }
        CampaignPlan plan = plan("<set attribute=\"robot/@speed\" value=\"0.2 0.3\" name=\"speed\"/>");
        String section = new VariantSections(new CampaignRuns(plan, lines)).comparisons();
        assertTrue(section.contains("<td>0<br><small>0 to 0; 10 pairs</small></td>"), section);
    }
}
