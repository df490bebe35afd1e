package faultline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.Threshold;
import faultline.control.Thresholds;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

class ExamplePlansTest {

    static Stream<Path> plans() throws Exception {
        return Files.list(Path.of("scenarios/campaigns")).sorted();
    }

    @Test
    void thePlanInTheDocumentsIsGood() throws Exception {
        Matcher snippet = Pattern.compile("(?s)```xml\n(<campaign.*?)```")
                .matcher(Files.readString(Path.of("docs/campaigns.md")));
        assertTrue(snippet.find());
        CampaignPlan plan = SamplePlan.read(snippet.group(1));
        assertEquals(360, plan.runCount());
    }

    @Test
    void thePlanOfThresholdsVariesThem() throws Exception {
        String page = Files.readString(Path.of("docs/campaigns.md"));
        Matcher snippet = Pattern.compile("(?s)```xml\n(<campaign.*?)```")
                .matcher(page.substring(page.indexOf("### Thresholds of the controller")));
        assertTrue(snippet.find());
        CampaignPlan plan = SamplePlan.read(snippet.group(1));
        assertEquals(60, plan.runCount());
        for (int i = 0; i < 3; i++) {
            Thresholds thresholds = ((ControllerSpec.WallFollowing)
                            plan.scenario(plan.run(i)).setup().controller())
                    .thresholds();
            assertEquals(0.05 * i, thresholds.get(Threshold.AHEAD_MARGIN), 1e-12);
            double lost = thresholds.get(Threshold.LOST_MARGIN);
            assertTrue(lost >= 0.04 && lost <= 0.1 && lost != 0.06, "drawn: " + lost);
        }
    }

    @ParameterizedTest
    @CsvSource({
        "survival, 60001 to 60040",
        "two-faults, 61001 to 61060",
        "wall-side-sensors, 62001 to 62060",
        "one-sensor, 63001 to 63060",
        "healthy, 64001 to 64400",
        "wrong-wheels, 65001 to 65040",
        "motor-faults, 66001 to 66040",
        "detection, 330001 to 330040"
    })
    void theResultsNameTheRoomsOfTheirPlans(String name, String rooms) throws Exception {
        CampaignPlan plan = PlanFiles.read(Path.of("scenarios/campaigns", name + ".xml"));
        String results = Files.readString(Path.of("docs/results.md"));
        assertTrue(results.contains("| `" + name + "` | " + rooms + " |"), rooms);
        PlannedRun last = plan.run(plan.runCount() - 1);
        assertEquals(rooms, (plan.run(0).world() + " to " + last.world()).replace("room-", ""));
        assertEquals(1, last.seed());
    }

    @ParameterizedTest
    @CsvSource({
        "wanted-distance, 0052-steps-away-from-a-wall, 3010001 to 3010100",
        "room-to-turn, 0052-steps-away-from-a-wall, 3030001 to 3030100",
        "replaced-follower, 0043-one-odometer, 3040001 to 3040120",
        "near-walls, 0053-near-walls, 3050001 to 3050100"
    })
    void theDecisionsNameTheRoomsOfTheirPlans(String name, String page, String rooms) throws Exception {
        CampaignPlan plan = PlanFiles.read(Path.of("scenarios/campaigns", name + ".xml"));
        String decision = Files.readString(Path.of("docs/decisions", page + ".md"));
        assertTrue(decision.replaceAll("\\s+", " ").contains("(" + rooms + ")"), rooms);
        PlannedRun last = plan.run(plan.runCount() - 1);
        assertEquals(rooms, (plan.run(0).world() + " to " + last.world()).replace("room-", ""));
    }

    @ParameterizedTest
    @MethodSource("plans")
    void everyShippedPlanIsGood(Path file) throws Exception {
        CampaignPlan plan = PlanFiles.read(file);
        assertTrue(plan.runCount() > 1);
        assertTrue(plan.scenario(plan.run(plan.runCount() - 1)).setup().duration() > 0);
    }
}
