package faultline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.CpuTime;
import faultline.JavaProcess;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.ScenarioLimits;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Plans with very many levels or elements: each is checked within 10 seconds of processor time and 512 MB. */
class HugePlansTest {

    private static final double MAX_SECONDS = 10;

    private static String repeat(int count, IntFunction<String> element) {
        return IntStream.range(0, count).mapToObj(element).collect(Collectors.joining());
    }

    private static String faults(String elements) {
        return "<faults>" + elements + "</faults>";
    }

    /** Returns a fault with some attributes, and three thousand levels of each of two others. */
    private static String nineMillionLevels(String attributes) {
        return "<fault " + attributes + " kind=\"stuck\" value=\"0..0.8/3000\" at=\"10..60/3000\"/>";
    }

    /** Returns masks: one for each sensor, and many of nearly a thousand sensors. */
    private static String masks(int sensors) {
        return "<masks sensors=\"" + repeat(sensors, i -> "s" + i + " ") + "\">"
                + repeat(sensors, i -> "<mask on=\"s" + i + "\"/>")
                + repeat(
                        2500,
                        i -> "<mask on=\"" + repeat(1000, j -> (i * 31 + j) % 97 == 0 ? "" : "s" + j + " ") + "\"/>")
                + "</masks>";
    }

    /** Returns rooms of each kind, with every smallest corner and number of visitors. */
    private static String rooms() {
        return repeat(
                4 * 46,
                i -> "<rooms first=\"" + i + "\" minCorner=\"" + (45 + i % 46) + "\" visitors=\"" + i / 46 + "\"/>");
    }

    private static String cones(int sensors) {
        return repeat(sensors, i -> "<set attribute=\"robot/sensor[s" + i + "]/@cone\" value=\"20\"/>");
    }

    /** Returns the problems of a plan, of which no more than a hundred are listed. */
    private static List<String> problemsOf(String elements) {
        return problemsOf("<worlds><scenario file=\"room.xml\"/></worlds>", elements);
    }

    private static List<String> problemsOf(String worlds, String elements) {
        assertTrue(elements.length() < ScenarioLimits.MAX_BYTES, elements.length() + " bytes");
        CpuTime time = CpuTime.start();
        List<String> problems = SamplePlan.problems(worlds, elements);
        time.assertBelow(MAX_SECONDS);
        assertTrue(problems.size() <= Problems.MAX_LISTED + 1, problems.size() + " problems");
        return problems;
    }

    /** Checks all plans; the test runs it in a separate process with limited memory. */
    static final class PlanChecks {

        private PlanChecks() {}

        public static void main(String[] args) {
            assertEquals(List.of(), problemsOf(faults(nineMillionLevels("sensor=\"left\""))));
            assertEquals(
                    List.of("plan.xml:3:9: the plan has 18000000 runs; expected 10000000 or fewer"),
                    problemsOf(faults(nineMillionLevels("sensor=\"left\"") + nineMillionLevels("sensor=\"right\""))));
            assertEquals(
                    List.of(),
                    problemsOf(faults(repeat(
                            100,
                            i -> "<fault kind=\"off\" sensor=\"left\" at=\"" + i + ".." + (i + 50) + "/99999\"/>"))));
            assertEquals(
                    List.of(),
                    problemsOf(faults(repeat(190_000, i -> "<fault kind=\"off\" sensor=\"left\" at=\"" + i + "\"/>"))));
            String odd = repeat(9000, i -> "b" + i + "=\"\" ");
            assertEquals(
                    "plan.xml: more problems: 8900",
                    problemsOf(faults("<fault kind=\"off\" sensor=\"left\" at=\"0..100/50000\" " + odd + "/>"))
                            .get(Problems.MAX_LISTED));
            assertEquals(1, problemsOf(masks(20_000)).size());
            problemsOf(masks(1008));
            assertEquals(
                    "plan.xml: more problems: 1",
                    problemsOf("<worlds>" + rooms() + "</worlds>", cones(20_000))
                            .get(Problems.MAX_LISTED));
            assertEquals(
                    Problems.MAX_LISTED + 1,
                    problemsOf("<worlds>" + rooms() + "</worlds>", cones(200_000))
                            .size());
            System.out.println("checked");
        }
    }

    @Test
    void everyPlanIsCheckedInTimeAndInHalfAGigabyte() throws Exception {
        Process process = JavaProcess.startWithHeap("512m", PlanChecks.class.getName(), List.of());
        assertEquals("checked\n", JavaProcess.output(process));
        assertEquals(0, process.waitFor());
    }

    /** The last run has the last values of both. */
    @Test
    void theLastOfNineMillionLevelsIsThatOfTheLastValues() throws ScenarioException {
        CampaignPlan plan = SamplePlan.read(SamplePlan.text(
                "", "<worlds><scenario file=\"a.xml\"/></worlds>" + faults(nineMillionLevels("sensor=\"left\""))));
        assertEquals(9_000_000, plan.runCount());
        assertEquals(
                List.of("stuck", "left", "0.8", "60", ""), plan.run(8_999_999).cells());
        assertEquals(List.of("stuck", "left", "0", "60", ""), plan.run(2999).cells());
    }

    @Test
    void aFaultThatSharesOnlySomeLevelsWithAnEarlierOneIsReported() {
        assertEquals(
                List.of("plan.xml:4:73: <fault> is the same as an earlier one; expected each fault once"),
                SamplePlan.problems(
                        """
                        <faults><fault kind="stuck" sensor="left" value="0..0.8/3" at="10..60/6"/>
                        <fault at="5 30" value="0.4 0.5" kind="bias stuck" sensor="front left"/></faults>
                        """));
    }

    @Test
    void valuesThatAreTooCloseToEachOtherToDifferAreReported() {
        List<String> problems =
                SamplePlan.problems(faults("<fault kind=\"off\" sensor=\"left\" at=\"1..1.0000000000000001/3\"/>"));
        assertEquals(1, problems.size(), problems::toString);
        assertTrue(problems.get(0).contains("<fault> is the same as an earlier one"), problems::toString);
    }
}
