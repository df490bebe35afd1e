package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.SamplePlan;
import faultline.campaign.run.CampaignFolder;
import faultline.campaign.run.CampaignRunner;
import faultline.campaign.run.Shard;
import faultline.scenario.xml.ScenarioException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Seeds of a world in which nothing is random give the same run, which is one observation. */
class RepeatedRunsTest {

    private static final String PLAN =
            """
            <worlds><scenario file="a.xml"/></worlds><seeds count="10"/>
            <set attribute="controller/@diagnosis" value="on off" name="diagnosis"/>
            <faults><fault kind="stuck" sensor="front" value="0.2..0.4" at="1"/></faults>
            """;

    @TempDir
    Path folder;

    private final List<String> header =
            new ArrayList<>(List.of("run", "block", "world", "carried_on", "trajectory_hash", "follow_rms_m"));
    private final List<List<String>> lines = new ArrayList<>(List.of(header));
    private CampaignPlan plan;

    @BeforeEach
    void readThePlan() throws ScenarioException {
        plan = SamplePlan.read(SamplePlan.text("", PLAN));
        plan.factorColumns().forEach(column -> header.add(column.name()));
    }

    private void addRun(int seed, String diagnosis, String value, String hash) {
        addRun(seed, diagnosis, value, hash, "");
    }

    private void addRun(int seed, String diagnosis, String value, String hash, String error) {
        List<String> cells = new ArrayList<>(Collections.nCopies(header.size(), ""));
        List<String> first = List.of(Integer.toString(lines.size() - 1), Integer.toString(seed), "a", "1", hash, error);
        for (int i = 0; i < first.size(); i++) {
            cells.set(i, first.get(i));
        }
        cells.set(header.indexOf("diagnosis"), diagnosis);
        cells.set(header.indexOf("fault_value"), value);
        lines.add(cells);
    }

    private CampaignRuns campaign() {
        return new CampaignRuns(plan, lines);
    }

    private static void assertIndependentRuns(int expected, CampaignRuns campaign) {
        Survival survival = Survival.of(campaign.rows());
        assertEquals(Interval.wilson(expected, expected), survival.interval());
        assertEquals(campaign.rows().size(), survival.n());
    }

    @Test
    void equalRunsAreOneObservation() {
        for (int seed = 0; seed < 10; seed++) {
            addRun(seed, "on", "0.3", "feed");
        }
        assertIndependentRuns(1, campaign());
        assertEquals(9, campaign().repeatCount());
    }

    @Test
    void runsWithOtherDrawsAreObservationsOfTheirOwn() {
        for (int seed = 0; seed < 10; seed++) {
            addRun(seed, "on", "0.3" + seed, "feed");
        }
        assertIndependentRuns(10, campaign());
    }

    @Test
    void runsWithOtherTrajectoriesAreObservationsOfTheirOwn() {
        for (int seed = 0; seed < 10; seed++) {
            addRun(seed, "on", "0.3", "feed" + seed);
        }
        assertIndependentRuns(10, campaign());
    }

    /** The robot may stand still, or meet nothing in which the worlds differ. */
    @Test
    void runsInOtherWorldsAreObservationsOfTheirOwn() {
        for (int world = 0; world < 10; world++) {
            addRun(world, "on", "0.3", "feed");
            lines.get(lines.size() - 1).set(header.indexOf("world"), "world " + world);
        }
        assertEquals(0, campaign().repeatCount());
        assertIndependentRuns(10, campaign());
    }

    /** The trajectory hash covers the noise of a sensor that the controller does not use. */
    @Test
    void runsWithEqualResultsAreOneObservation() {
        for (int seed = 0; seed < 10; seed++) {
            addRun(seed, "on", "0.3", "feed" + seed, "0.001234");
        }
        assertIndependentRuns(1, campaign());
        assertEquals(9, campaign().repeatCount());
    }

    @Test
    void runsWithOtherResultsAreObservationsOfTheirOwn() {
        for (int seed = 0; seed < 10; seed++) {
            addRun(seed, "on", "0.3", "feed" + seed, "0.00123" + seed);
        }
        assertIndependentRuns(10, campaign());
    }

    /** A run that failed has no trajectory. */
    @Test
    void runsWithoutATrajectoryAreObservationsOfTheirOwn() {
        for (int seed = 0; seed < 10; seed++) {
            addRun(seed, "on", "0.3", "");
        }
        assertIndependentRuns(10, campaign());
        assertEquals(0, campaign().repeatCount());
    }

    @Test
    void aPairIsRepeatedIfBothRunsAre() {
        for (int seed = 0; seed < 10; seed++) {
            addRun(seed, "on", "0.3", "feed");
            addRun(seed, "off", "0.3", "dead");
        }
        assertEquals(Interval.pairedDifference(1, 0, 0, 0), difference());
    }

    @Test
    void aPairIsNotRepeatedIfItsSecondRunDiffers() {
        for (int seed = 0; seed < 10; seed++) {
            addRun(seed, "on", "0.3", "feed");
            addRun(seed, "off", "0.3", "dead" + seed);
        }
        assertEquals(Interval.pairedDifference(10, 0, 0, 0), difference());
    }

    private Interval difference() {
        Comparison comparison = new Comparison(campaign(), plan.factors().get(0));
        Map<String, List<RunRow>> levels = comparison.levels(campaign().rows());
        return comparison
                .survival(levels.get("on"), levels.get("off"))
                .orElseThrow()
                .interval();
    }

    @Test
    void theReportSaysHowManyRunsAreRepeated() throws Exception {
        String world = "<set attribute=\"@duration\" value=\"3\"/><worlds><scenario file=\"a.xml\"/></worlds>";
        String report = report(world + "<seeds count=\"4\"/>");
        assertTrue(report.contains("<p>Repeated runs (3) differ from an earlier one only"), report);
        String noise = "<set attribute=\"robot/sensor[left]/@noise\" value=\"0.01\"/>";
        assertFalse(report(world + "<seeds count=\"4\"/>" + noise).contains("Repeated runs"));
    }

    @Test
    void theReportWarnsOfFewWorldsOrSeeds() throws Exception {
        String one = "<worlds><scenario file=\"a.xml\"/></worlds>";
        String two = "<worlds><scenario file=\"a.xml\"/><scenario file=\"b.xml\"/></worlds>";
        assertTrue(report(two).contains("With only 2 worlds, the correlation of runs is uncertain"));
        assertTrue(report(one + "<seeds count=\"9\"/>").contains("With only 9 seeds"));
        assertFalse(report(one + "<seeds count=\"10\"/>").contains("With only"));
        assertFalse(report(one).contains("With only"));
    }

    private String report(String elements) throws Exception {
        CampaignPlan plan = SamplePlan.read(SamplePlan.text("", elements));
        Path out = folder.resolve(Integer.toString(elements.length()));
        new CampaignRunner(plan, new CampaignFolder(out), Shard.ALL, 1).run(true, (made, runs) -> {}, () -> false);
        return new CampaignReport(out).html(List.of());
    }
}
