package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.SamplePlan;
import faultline.scenario.xml.ScenarioException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class ComparisonTest {

    private static final String PLAN =
            """
            <worlds><scenario file="a.xml"/><scenario file="b.xml"/><scenario file="c.xml"/></worlds>
            <seeds count="2"/>
            <set attribute="robot/@speed" value="0.2 0.3" name="speed"/>
            <faults><fault kind="off" sensor="front" at="1"/></faults>
            """;

    private static final String SLOW = "0.2";
    private static final String FAST = "0.3";

    private CampaignPlan plan;
    private final List<List<String>> lines = new ArrayList<>();

    @BeforeEach
    void readThePlan() throws ScenarioException {
        plan = SamplePlan.read(SamplePlan.text("", PLAN));
        List<String> header = new ArrayList<>(List.of("run", "block", "world", "carried_on", "coverage"));
        plan.factorColumns().forEach(column -> header.add(column.name()));
        lines.add(header);
    }

    private void addRun(int block, String world, String speed, String sensor, String carriedOn, double coverage) {
        List<String> cells = new ArrayList<>(Collections.nCopies(lines.get(0).size(), ""));
        set(cells, "run", Integer.toString(lines.size() - 1));
        set(cells, "block", Integer.toString(block));
        set(cells, "world", world);
        set(cells, "speed", speed);
        set(cells, "fault_kind", "off");
        set(cells, "fault_sensor", sensor);
        set(cells, "carried_on", carriedOn);
        set(cells, "coverage", Double.toString(coverage));
        lines.add(cells);
    }

    private void set(List<String> cells, String column, String text) {
        cells.set(lines.get(0).indexOf(column), text);
    }

    /** Adds a run at either speed, with the coverage of each. */
    private void addPair(int block, String world, double slow, double fast) {
        addRun(block, world, SLOW, "front", "0", slow);
        addRun(block, world, FAST, "front", "1", fast);
    }

    private CampaignRuns campaign() {
        return new CampaignRuns(plan, lines);
    }

    private Comparison comparison() {
        return new Comparison(campaign(), plan.factors().get(0));
    }

    private Optional<Comparison.Difference> numberDifference() {
        Comparison speeds = comparison();
        List<RunRow> all = campaign().rows();
        return speeds.number(
                speeds.levels(all).getOrDefault(SLOW, List.of()),
                speeds.levels(all).getOrDefault(FAST, List.of()),
                "coverage");
    }

    private Optional<Comparison.Difference> survivalDifference() {
        Comparison speeds = comparison();
        List<RunRow> all = campaign().rows();
        return speeds.survival(speeds.levels(all).get(SLOW), speeds.levels(all).get(FAST));
    }

    /** The means of the worlds are 0.2, 0.3 and 0.4, and the 0.975 quantile of Student's t for them is 4.302653. */
    @Test
    void theIntervalOfADifferenceComesFromTheMeansOfTheWorlds() {
        addPair(0, "a", 0.5, 0.6);
        addPair(1, "a", 0.5, 0.8);
        addPair(2, "b", 0.4, 0.7);
        addPair(3, "b", 0.3, 0.6);
        addPair(4, "c", 0.1, 0.5);
        addPair(5, "c", 0.2, 0.6);
        Comparison.Difference difference = numberDifference().orElseThrow();
        assertEquals(0.3, difference.value(), 1e-12);
        assertEquals(6, difference.pairs());
        double half = 4.302653 * 0.1 / Math.sqrt(3);
        assertEquals(0.3 - half, difference.interval().low(), 1e-6);
        assertEquals(0.3 + half, difference.interval().high(), 1e-6);
    }

    @Test
    void aRunWithoutAPartnerDoesNotCount() {
        addPair(0, "a", 0.5, 0.6);
        addRun(1, "a", FAST, "front", "1", 0.9);
        addRun(0, "a", FAST, "left", "1", 0.9);
        assertEquals(1, numberDifference().orElseThrow().pairs());
    }

    /** The means of the worlds are 0.2 and 0.4, and the 0.975 quantile of Student's t for them is 12.706205. */
    @Test
    void twoWorldsGiveAWideInterval() {
        addPair(0, "a", 0.5, 0.7);
        addPair(1, "b", 0.3, 0.7);
        Interval interval = numberDifference().orElseThrow().interval();
        assertEquals(0.3 - 1.2706205, interval.low(), 1e-6);
        assertEquals(0.3 + 1.2706205, interval.high(), 1e-6);
    }

    @Test
    void aPairOfWhichARunHasNoNumberDoesNotCount() {
        addPair(0, "a", 0.5, 0.6);
        addPair(1, "a", 0.4, Double.NaN);
        addPair(2, "a", Double.NaN, 0.4);
        assertEquals(1, numberDifference().orElseThrow().pairs());
    }

    /** More than forty faults are grouped by fault and by sensor. */
    @Test
    void aSensorMayHaveTheNameOfAFault() {
        addRun(0, "a", SLOW, "", "1", 0.9);
        for (int i = 0; i < 40; i++) {
            addRun(i + 1, "a", SLOW, "s" + i, "1", 0.9);
        }
        addRun(41, "a", SLOW, "off", "0", 0.1);
        List<String> groups = comparison().faultGroups().stream()
                .map(group -> group.name() + " " + group.runs().size())
                .toList();
        assertEquals(List.of("all runs 42", "healthy 1", "off 41", "s0 1"), groups.subList(0, 4));
        assertEquals("off 1", groups.get(groups.size() - 1));
        assertEquals(1, Collections.frequency(groups, "healthy 1"));
    }

    @Test
    void withoutPairsThereIsNoDifference() {
        addRun(0, "a", FAST, "front", "1", 0.9);
        assertEquals(Optional.empty(), numberDifference());
    }

    @Test
    void theDifferenceOfSharesIsThatOfTheSecondFromTheFirst() {
        addPair(0, "a", 0, 0);
        addPair(1, "a", 0, 0);
        addPair(2, "b", 0, 0);
        addRun(3, "b", SLOW, "front", "1", 0);
        addRun(3, "b", FAST, "front", "0", 0);
        assertEquals(0.5, survivalDifference().orElseThrow().value());
        assertEquals(4, survivalDifference().orElseThrow().pairs());
    }

    @Test
    void aPairWithAnUndecidedRunIsInNoShare() {
        addPair(0, "a", 0, 0);
        addRun(1, "a", SLOW, "front", "1", 0);
        addRun(1, "a", FAST, "front", "", 0);
        assertEquals(1, survivalDifference().orElseThrow().pairs());
    }

    /**
     * Adds twelve pairs of runs in each of three worlds; the second runs carry on, and so do the first ones that the
     * pattern of a world says, which repeats.
     */
    private double intervalWidth(String... firstRuns) {
        lines.subList(1, lines.size()).clear();
        for (int block = 0; block < 12 * firstRuns.length; block++) {
            int world = block / 12;
            String pattern = firstRuns[world];
            char first = pattern.charAt(block % pattern.length());
            addRun(block, "abc".substring(world, world + 1), SLOW, "front", String.valueOf(first), 0);
            addRun(block, "abc".substring(world, world + 1), FAST, "front", "1", 0);
        }
        Interval interval = survivalDifference().orElseThrow().interval();
        return interval.high() - interval.low();
    }

    @Test
    void runsOfAWorldThatAreAlikeMakeTheIntervalWider() {
        assertTrue(intervalWidth("0", "1", "1") > 1.1 * intervalWidth("011", "011", "011"));
    }

    /** In each world, the robot carries on in the first or in the second run of half of the pairs. */
    @Test
    void pairsThatDifferInBothDirectionsAreMoreThanOneObservationOfAWorld() {
        for (int block = 0; block < 36; block++) {
            String world = List.of("a", "b", "c").get(block / 12);
            addRun(block, world, SLOW, "front", Integer.toString(block % 2), 0);
            addRun(block, world, FAST, "front", Integer.toString(1 - block % 2), 0);
        }
        Interval found = survivalDifference().orElseThrow().interval();
        Interval ofThreePairs = Interval.pairedDifference(0, 1.5, 1.5, 0);
        assertTrue(found.high() < 0.9 * ofThreePairs.high(), found + " is not within " + ofThreePairs);
    }

    /**
     * Returns the interval of pairs of runs in worlds, of which each repeats its pair; 01 is one in the second only.
     */
    private Interval intervalOfRepeatedPairs(String... pairs) {
        lines.subList(1, lines.size()).clear();
        int block = 0;
        for (int world = 0; world < pairs.length; world++) {
            for (int i = 0; i < 4; i++) {
                addRun(block, "w" + world, SLOW, "front", pairs[world].substring(0, 1), 0);
                addRun(block, "w" + world, FAST, "front", pairs[world].substring(1), 0);
                block++;
            }
        }
        return survivalDifference().orElseThrow().interval();
    }

    /** All four kinds of pairs have the same weight. */
    @Test
    void theIntervalOfFailuresIsTheMirrorImageOfThatOfSuccesses() {
        Interval successes = intervalOfRepeatedPairs("01", "01", "11", "11", "11", "00", "10");
        Interval failures = intervalOfRepeatedPairs("10", "10", "00", "00", "00", "11", "01");
        assertEquals(-failures.high(), successes.low(), 1e-12);
        assertEquals(-failures.low(), successes.high(), 1e-12);
    }

    private List<String> groups(int sensors) {
        IntStream.range(0, sensors).forEach(sensor -> addRun(sensor, "a", SLOW, "s" + sensor, "1", 0));
        return comparison().faultGroups().stream()
                .map(Comparison.RunGroup::name)
                .toList();
    }

    @Test
    void theRunsOfTheOnlyFaultAreAllRuns() {
        assertEquals(List.of("all runs"), groups(1));
    }

    @Test
    void upToFortyFaultsAreGroupsOfTheirOwn() {
        Stream<String> faults = IntStream.range(0, 40).mapToObj(sensor -> "s" + sensor + " off");
        assertEquals(Stream.concat(Stream.of("all runs"), faults).toList(), groups(40));
    }

    @Test
    void moreThanFortyFaultsAreGroupedByFaultAndBySensor() {
        Stream<String> sensors = IntStream.range(0, 41).mapToObj(sensor -> "s" + sensor);
        assertEquals(Stream.concat(Stream.of("all runs", "off"), sensors).toList(), groups(41));
    }
}
