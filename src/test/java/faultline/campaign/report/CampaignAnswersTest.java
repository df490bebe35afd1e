package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.SamplePlan;
import faultline.campaign.run.CampaignFolder;
import faultline.campaign.run.CampaignRunner;
import faultline.campaign.run.Shard;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The answer that docs/campaigns.md gives to the question of its first plan is that of the present follower. */
class CampaignAnswersTest {

    @TempDir
    Path folder;

    @Test
    void theFirstPlanHasTheAnswerThatThePageGives() throws Exception {
        String page = Files.readString(Path.of("docs/campaigns.md"));
        String text = page.substring(page.indexOf("<campaign"), page.indexOf("</campaign>") + "</campaign>".length());
        CampaignPlan plan =
                SamplePlan.read(text.replace("<healthy/>", "").replace("  <faults>", setting(page) + "\n  <faults>"));
        new CampaignRunner(plan, new CampaignFolder(folder), Shard.ALL, 1).run(true, (made, runs) -> {}, () -> false);
        CampaignRuns campaign = CampaignRuns.read(plan, folder.resolve("runs.csv"));
        Map<String, List<RunRow>> cones = CampaignRuns.group(campaign.rows(), row -> row.text("front_cone_deg"));
        String said = String.format(
                Locale.ROOT,
                "is stuck in %s with a cone of 20 degrees, in %s with 10 degrees and in %s with 5 degrees.",
                share(cones.get("20"), " of 60 runs"),
                share(cones.get("10"), ""),
                share(cones.get("5"), ""));
        assertTrue(page.replaceAll("\\s+", " ").contains(said), () -> "the page should say: " + said);
        assertAnalysisSays(cones);
    }

    /** The programs of docs/analysis.md take the base level of the report, and only runs with a fault. */
    private static void assertAnalysisSays(Map<String, List<RunRow>> cones) throws Exception {
        double[] shares = Stream.of("20", "10", "5")
                .mapToDouble(cone -> Survival.of(cones.get(cone)).share())
                .toArray();
        String said = String.format(
                Locale.ROOT,
                "%.3f, %.3f and %.3f at 20, 10 and 5 degrees, and differences of %.3f and %.3f",
                shares[0],
                shares[1],
                shares[2],
                shares[1] - shares[0],
                shares[2] - shares[0]);
        String page = Files.readString(Path.of("docs/analysis.md")).replaceAll("\\s+", " ");
        assertTrue(page.contains(said), () -> "the page should say: " + said);
    }

    /** Returns the element that the page adds to the plan. */
    private static String setting(String page) {
        int begin = page.indexOf("<set", page.indexOf("**The answer.**"));
        return page.substring(begin, page.indexOf("/>", begin) + 2);
    }

    private static String share(List<RunRow> rows, String of) {
        Survival survival = Survival.of(rows);
        assertEquals(60, survival.n());
        return String.format(
                Locale.ROOT,
                "%.0f %%%s (%.0f to %.0f %%)",
                100 * survival.share(),
                of,
                100 * survival.interval().low(),
                100 * survival.interval().high());
    }
}
