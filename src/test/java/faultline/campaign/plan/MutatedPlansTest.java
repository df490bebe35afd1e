package faultline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertTimeout;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.scenario.xml.FileMutator;
import faultline.scenario.xml.Problem;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.SchemaCheck;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Tests plans that are damaged at random: each is rejected with messages of the documented form, or is valid by the
 * schema and gives its runs. A tenth of the system property {@code faultline.fuzz} is the number of plans.
 */
class MutatedPlansTest {

    private static final int PLANS = Integer.getInteger("faultline.fuzz", 3000) / 10;
    private static final Duration MAX_TIME = Duration.ofSeconds(10);

    private static final SchemaCheck SCHEMA = new SchemaCheck(PlanReader.class.getResource("campaign-1.xsd"));

    private final FileMutator mutator = new FileMutator();

    @Test
    void damagedPlansAreRefusedOrGiveTheirRuns() throws IOException {
        List<String> originals = new ArrayList<>();
        try (Stream<Path> files = Files.list(Path.of("scenarios/campaigns"))) {
            for (Path file : files.sorted().toList()) {
                originals.add(Files.readString(file));
            }
        }
        int refused = 0;
        for (int i = 0; i < PLANS; i++) {
            byte[] plan = mutator.damaged(mutator.pick(originals));
            refused += assertTimeout(MAX_TIME, () -> isRefused(plan), () -> text(plan)) ? 1 : 0;
        }
        assertTrue(2 * refused > PLANS && refused < PLANS, refused + " were refused");
    }

    private static String text(byte[] plan) {
        return new String(plan, StandardCharsets.UTF_8);
    }

    private static boolean isRefused(byte[] bytes) {
        try {
            CampaignPlan plan = PlanReader.read(
                    "plan.xml", bytes, (number, name) -> SamplePlan.ROOM.getBytes(StandardCharsets.UTF_8));
            SCHEMA.assertValid(bytes);
            assertTrue(plan.runCount() >= 1);
            plan.run(plan.runCount() - 1);
            return false;
        } catch (ScenarioException e) {
            for (Problem problem : e.problems()) {
                String line = problem.toString();
                assertTrue(line.matches("plan\\.xml:(\\d+:\\d+:)? [^\\p{Cc}]{5,}"), () -> line + "\n" + text(bytes));
            }
            return true;
        } catch (RuntimeException | Error e) {
            throw new AssertionError(text(bytes), e);
        }
    }
}
