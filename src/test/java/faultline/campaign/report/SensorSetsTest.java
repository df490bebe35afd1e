package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.CpuTime;
import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.SamplePlan;
import faultline.scenario.xml.ScenarioException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The sets of sensors with which the robot carries on. */
class SensorSetsTest {

    private CampaignPlan plan;
    private final List<List<String>> lines = new ArrayList<>();

    @BeforeEach
    void readThePlan() throws ScenarioException {
        plan = SamplePlan.read(SamplePlan.text(
                "", "<worlds><scenario file=\"a.xml\"/></worlds><seeds count=\"20\"/><masks sensors=\"front left\"/>"));
        lines.add(List.of("run", "block", "world", plan.factorColumns().get(0).name(), "carried_on"));
    }

    /** Adds runs with a set, in some of which the robot carries on. */
    private void addRuns(String set, int successes, int runs) {
        for (int i = 0; i < runs; i++) {
            lines.add(List.of(
                    Integer.toString(lines.size() - 1), Integer.toString(i), "a", set, i < successes ? "1" : "0"));
        }
    }

    private String section() {
        return new FaultSections(new CampaignRuns(plan, lines)).sensorSets();
    }

    private static String row(String set) {
        return "<th scope=\"row\">" + set + "</th>";
    }

    @Test
    void aSufficientSetIsMinimalIfNoSmallerOneInsideItIs() {
        addRuns("none", 0, 20);
        addRuns("front", 20, 20);
        addRuns("left", 0, 20);
        addRuns("front left", 20, 20);
        assertTrue(section().contains(row("front")), section());
        assertFalse(section().contains(row("front left")), section());
        assertTrue(section().contains(" 2 of 4 sets are sufficient."), section());
    }

    @Test
    void theBestSetOfASizeIsTheOneWithTheGreatestShare() {
        addRuns("front", 5, 20);
        addRuns("left", 15, 20);
        assertTrue(section().contains(row("1") + "<td>2</td><td>0</td><td>left</td>"), section());
    }

    @Test
    void aSetIsSufficientFromEightyFivePerCentOn() {
        addRuns("front", 17, 20);
        addRuns("left", 16, 20);
        assertTrue(section().contains(row("front")), section());
        assertFalse(section().contains(row("left")), section());
    }

    /** The interval of n of n begins at n / (n + 1.96 squared), which is 0.845 for 21 and 0.851 for 22. */
    @Test
    void aSetIsCertainIfItsIntervalBeginsAtEightyFivePerCent() {
        addRuns("front", 22, 22);
        addRuns("left", 21, 21);
        assertTrue(section().contains(row("front") + "<td>1</td><td>yes</td>"), section());
        assertTrue(section().contains(row("left") + "<td>1</td><td>no</td>"), section());
        assertTrue(section().contains("; 1 are certain."), section());
        String limits = "interval is at 85 % or more, which requires 22 independent runs or more;";
        assertTrue(section().contains(limits), section());
    }

    /** Reads a plan with these elements, and begins its table. */
    private void usePlan(String elements) throws ScenarioException {
        plan = SamplePlan.read(
                SamplePlan.text("", "<worlds><scenario file=\"a.xml\"/></worlds><seeds count=\"20\"/>" + elements));
        List<String> header = new ArrayList<>(List.of("run", "block", "world", "carried_on"));
        plan.factorColumns().forEach(column -> header.add(column.name()));
        lines.clear();
        lines.add(header);
    }

    /** Adds 20 runs with these values of the first columns of factors, in some of which the robot carries on. */
    private void addRuns(int successes, String... values) {
        for (int i = 0; i < 20; i++) {
            List<String> line = new ArrayList<>(
                    List.of(Integer.toString(lines.size() - 1), Integer.toString(i), "a", i < successes ? "1" : "0"));
            line.addAll(List.of(values));
            line.addAll(Collections.nCopies(lines.get(0).size() - line.size(), ""));
            lines.add(line);
        }
    }

    /** Without diagnosis no single sensor is enough, with it each is. Of all runs of "front", 50 % carry on. */
    @Test
    void eachLevelOfTheComparedSettingHasItsOwnSection() throws ScenarioException {
        usePlan("<masks sensors=\"front left\"/><set attribute=\"controller/@diagnosis\" value=\"on off\"/>");
        addRuns(20, "front", "1", "on");
        addRuns(20, "front left", "2", "on");
        addRuns(0, "front", "1", "off");
        addRuns(20, "front left", "2", "off");
        String[] sections = section().split("<section>");
        assertEquals(3, sections.length, section());
        assertTrue(sections[1].contains("<h2>Minimum sets of sensors: controller_diagnosis on</h2>"), sections[1]);
        assertTrue(sections[1].contains(" 2 of 2 sets are sufficient."), sections[1]);
        assertTrue(sections[1].contains(row("front")), sections[1]);
        assertTrue(sections[2].contains("<h2>Minimum sets of sensors: controller_diagnosis off</h2>"), sections[2]);
        assertTrue(sections[2].contains(" 1 of 2 sets are sufficient."), sections[2]);
        assertFalse(sections[2].contains(row("front")), sections[2]);
        assertTrue(sections[2].contains(row("front left")), sections[2]);
        assertFalse(section().contains("The runs of a set are those"), section());
    }

    @Test
    void theReportNamesTheFactorsWhoseLevelsASetIncludes() throws ScenarioException {
        usePlan("<set attribute=\"controller/@diagnosis\" value=\"on off\"/>"
                + "<set attribute=\"robot/@speed\" value=\"0.2 0.3\"/>"
                + "<set attribute=\"controller/@distance\" value=\"0.2..0.3\"/>"
                + "<faults><healthy/><fault sensor=\"front\" kind=\"off\" at=\"1\"/></faults>"
                + "<masks sensors=\"front left\"/>");
        addRuns(20, "on");
        String sentence = " The runs of a set are those with all levels of robot_speed_m_s, fault_kind.</p>";
        assertTrue(section().contains(sentence), section());
    }

    @Test
    void theSensorsOfSeveralMasksAreOneSet() throws ScenarioException {
        usePlan("<masks sensors=\"front left\"/><masks sensors=\"rear right\" name=\"others\"/>");
        addRuns(0, "none", "0", "none", "0");
        addRuns(0, "none", "0", "rear", "1");
        addRuns(20, "left", "1", "rear", "1");
        addRuns(20, "none", "0", "right", "1");
        addRuns(20, "left", "1", "none", "0");
        assertTrue(section().contains(" 3 of 5 sets are sufficient."), section());
        assertTrue(section().contains(row("left") + "<td>1</td>"), section());
        assertTrue(section().contains(row("right") + "<td>1</td>"), section());
        assertFalse(section().contains(row("left rear")), section());
        assertTrue(section().contains(row("2") + "<td>1</td><td>1</td><td>left rear</td>"), section());
    }

    @Test
    void setsOfFewerSensorsComeFirstThenThoseOfGreaterShares() {
        addRuns("front left", 20, 20);
        addRuns("rear", 17, 20);
        addRuns("right", 18, 20);
        assertTrue(section().indexOf(row("right")) < section().indexOf(row("rear")), section());
        assertTrue(section().indexOf(row("rear")) < section().indexOf(row("front left")), section());
    }

    /** All sets of 16 sensors, of which those of eight or more are sufficient. */
    @Test
    void theMinimumSetsOfManyAreFoundAtOnce() {
        for (int bits = 0; bits < 1 << 16; bits++) {
            int on = bits;
            String set = IntStream.range(0, 16)
                    .filter(sensor -> (on >> sensor & 1) == 1)
                    .mapToObj(sensor -> "s" + sensor)
                    .collect(Collectors.joining(" "));
            addRuns(set.isEmpty() ? "none" : set, Integer.bitCount(bits) >= 8 ? 1 : 0, 1);
        }
        CpuTime time = CpuTime.start();
        String section = section();
        time.assertBelow(8);
        String minimum = section.substring(0, section.indexOf("All sets"));
        assertEquals(12_870, minimum.split("<td>8</td>", -1).length - 1, "16 over 8");
        assertTrue(section.contains(" 39203 of 65536 sets are sufficient."), () -> section.substring(0, 500));
    }

    /** All pairs of 400 sensors, each sufficient. Comparing each with all others takes half a minute. */
    @Test
    void manySetsOfOneSizeAreNotCompared() {
        for (int i = 0; i < 400; i++) {
            for (int j = 0; j < i; j++) {
                addRuns("s" + i + " s" + j, 1, 1);
            }
        }
        addRuns("s0 s1 s2", 1, 1);
        CpuTime time = CpuTime.start();
        String section = section();
        time.assertBelow(8);
        String minimum = section.substring(0, section.indexOf("All sets"));
        assertEquals(79_800, minimum.split("<td>2</td>", -1).length - 1, "400 over 2");
        assertFalse(minimum.contains(row("s0 s1 s2")));
    }

    /** More than the 64 sensors of one word. */
    @Test
    void aSetOfManySensorsIsComparedAsAWhole() {
        String most = IntStream.range(0, 70).mapToObj(i -> "s" + i).collect(Collectors.joining(" "));
        addRuns(most, 20, 20);
        addRuns("s0 s70", 20, 20);
        addRuns(most + " s71", 20, 20);
        assertTrue(section().contains(" 3 of 3 sets are sufficient."), section());
        assertTrue(section().contains(row("s0 s70")), section());
        assertTrue(section().contains(row(most)), section());
        assertFalse(section().contains(row(most + " s71")), section());
    }

    @Test
    void withoutASufficientSetTheReportSaysSo() {
        addRuns("none", 0, 20);
        assertTrue(section().contains("No set is sufficient."), section());
    }

    @Test
    void anIdWithBlanksIsOneSensor() {
        addRuns("\"front nose\" left", 20, 20);
        assertTrue(
                section().contains(row("2") + "<td>1</td><td>1</td><td>&quot;front nose&quot; left</td>"), section());
    }

    /** "none" is a legal id; the set of no sensors has the same name without quotes. */
    @Test
    void aSensorThatIsCalledNoneIsOneSensor() {
        addRuns("none", 0, 20);
        addRuns("\"none\"", 20, 20);
        assertTrue(section().contains(row("&quot;none&quot;") + "<td>1</td>"), section());
        assertTrue(section().contains(" 1 of 2 sets are sufficient."), section());
    }

    @Test
    void aSetWithoutDecidedRunsIsNotTheBestOne() {
        lines.add(List.of("0", "0", "a", "front", ""));
        addRuns("left", 0, 20);
        assertTrue(section().contains(row("1") + "<td>2</td><td>0</td><td>left</td>"), section());
    }
}
