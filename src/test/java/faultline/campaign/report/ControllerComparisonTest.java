package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.geometry.Pose;
import faultline.scenario.RunSummary;
import faultline.scenario.Scenario;
import faultline.world.WorldSpec;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

class ControllerComparisonTest {

    private static final SimulationSetup ROOM = SimulationSetup.of(
                    new WorldSpec(3, 2, true, 0, List.of()), new Pose(1.5, 1, 0))
            .withDuration(0.1)
            .withSeed(7);
    private static final List<ControllerRuns.FailedRun> BROKEN =
            List.of(new ControllerRuns.FailedRun(8, "it ended, with \"exit\" code <5>"));

    /** Returns runs without a collision, the first with the seed 7, in which the robot drives some metres. */
    private static ControllerRuns runs(String controller, List<ControllerRuns.FailedRun> broken, double... metres) {
        List<ControllerRuns.ComparedRun> runs = Arrays.stream(metres)
                .mapToObj(each -> ControllerRuns.ComparedRun.of(result(7), List.of(), each))
                .toList();
        return new ControllerRuns(controller, runs, broken);
    }

    private static RunResult result(long seed) {
        return HeadlessRun.run(ROOM.withSeed(seed), ControllerMode.DIRECT, List.of());
    }

    private static ControllerComparison comparison(String name, ControllerRuns... controllers) {
        return new ControllerComparison(
                new Scenario(name, "", false, ROOM, Expectation.NONE),
                "room.xml",
                List.of(controllers),
                List.of(),
                false);
    }

    @Test
    void theLinesAreInColumnsUnderAHeader() {
        assertEquals(
                List.of(
                        "controller  runs            coverage  distance_rms_m  collision  path_m",
                        "own         1 and 1 broken  none      none            0.00       1.00",
                        "another     1               none      none            0.00       3.00",
                        "third       1               none      none            0.00       0.50",
                        "2 less 1    1 pair          none      none            0.00       2.00",
                        "3 less 1    1 pair          none      none            0.00       -0.50"),
                comparison("Room", runs("own", BROKEN, 1), runs("another", List.of(), 3), runs("third", List.of(), 0.5))
                        .lines());
    }

    @Test
    void everyRunHasARowOfAllColumns() {
        String hash = RunSummary.formatHash(result(7));
        assertEquals(
                """
                controller,seed,coverage,distance_rms_m,collision,path_m,state,trajectory_hash,problem
                own,7,,,0.0,1,SEARCH,%1$s,
                own,8,,,,,,,"it ended, with ""exit"" code <5>"
                another,7,,,0.0,0.00052,SEARCH,%1$s,
                another,7,,,0.0,12345678.5,SEARCH,%1$s,
                """
                        .formatted(hash),
                comparison("Room", runs("own", BROKEN, 1), runs("another", List.of(), 0.00052, 12_345_678.5))
                        .csv());
    }

    @Test
    void aPageWithOneSeedAndWithoutTimelineNamesOnlyWhatThereIs() {
        String html = comparison("", runs("own", List.of(), 1), runs("another", List.of(), 3))
                .html();
        assertTrue(html.contains("<h1>Controllers in a scenario</h1>"), html);
        assertTrue(html.contains("<p>Scenario file: room.xml. Seed: 7. Duration: 0.1 s. Version: "), html);
        for (String absent : List.of("In the window", "Refused commands", "Broken runs", "ground truth", "only ")) {
            assertFalse(html.contains(absent), absent);
        }
    }

    @Test
    void aPageHasAPictureOfEachNumberAndBrokenRunsCountAsSeeds() {
        ControllerRuns own = runs("own", BROKEN, 1);
        String html = comparison("Room", own).html();
        assertTrue(html.contains("<h1>Controllers in Room</h1>"), html);
        assertTrue(html.contains("Seeds: 7 to 8."), html);
        for (Metric metric : Metric.values()) {
            assertTrue(html.contains(ComparisonChart.spread(metric, List.of(own))), metric.column());
        }
        assertFalse(html.contains("Differences"), "there is one controller");
    }

    @Test
    void namesAndReasonsAreNoMarkup() {
        String html = comparison("<b>", runs("a<b>", BROKEN, 1), runs("c<b>", BROKEN, 3))
                .html();
        assertFalse(html.contains("<b>"), html);
        assertTrue(html.contains("Differences to a&lt;b&gt; in runs with the same seed"), html);
        assertTrue(html.contains("<td>it ended, with &quot;exit&quot; code &lt;5&gt;</td>"), html);
    }

    @Test
    void runsThatAreEqualAreReportedForEachControllerIfOthersBroke() {
        ControllerRuns whole = runs("whole", List.of(), 1, 1);
        assertEquals(
                List.of("nothing in these runs is random, so every seed gives the same run"),
                comparison("Room", whole, whole).seedRemarks());
        assertEquals(
                List.of(
                        "the completed runs of broken have the same results and count once",
                        "the completed runs of whole have the same results and count once"),
                comparison("Room", runs("broken", BROKEN, 1, 1), whole).seedRemarks());
        assertEquals(List.of(), comparison("Room", runs("single", List.of(), 1)).seedRemarks());
    }

    @Test
    void controllersWithoutACompletedRunDoNotHaveTheSameRuns() {
        ControllerRuns none = runs("none", BROKEN);
        assertEquals(List.of(), comparison("Room", none, none).sameRunRemarks());
        ControllerRuns one = runs("one", List.of(), 1);
        assertEquals(List.of(), comparison("Room", none, one).sameRunRemarks());
        assertEquals(
                List.of("the completed runs of the controllers 2 and 3 are the same"),
                comparison("Room", none, one, one).sameRunRemarks());
    }
}
