package faultline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
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

    @ParameterizedTest
    @MethodSource("plans")
    void everyShippedPlanIsGood(Path file) throws Exception {
        CampaignPlan plan = PlanFiles.read(file);
        assertTrue(plan.runCount() > 1);
        assertTrue(plan.scenario(plan.run(plan.runCount() - 1)).setup().duration() > 0);
    }
}
