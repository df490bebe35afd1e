package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.SamplePlan;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a campaign leaves in its folder while a run is made, and how long its runs take. */
class RunsInProgressTest {

    /** The checks for cancellation, 50 ms apart, after which a row without its place in the table is missing. */
    private static final int MAX_CHECKS = 400;

    @TempDir
    Path folder;

    private static CampaignPlan plan(String durations) throws Exception {
        return SamplePlan.read(SamplePlan.text(
                "",
                "<worlds><scenario file=\"room.xml\"/></worlds><set attribute=\"@duration\" value=\"" + durations
                        + "\"/>"));
    }

    private List<String> rows(String table) {
        try {
            List<String> lines = Files.readAllLines(folder.resolve(table));
            return lines.subList(1, lines.size());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** The second run would take an hour. */
    @Test
    void rowsAreInTheTableWhileTheNextRunIsMadeAndThatEndsWhenTheCampaignIsCancelled() throws Exception {
        AtomicInteger checks = new AtomicInteger();
        CampaignRunner.RunCounts result = new CampaignRunner(
                        plan("1 10000000"), new CampaignFolder(folder), Shard.ALL, 1)
                .run(
                        false,
                        (made, runs) -> {},
                        () -> !rows("runs.csv").isEmpty() || checks.incrementAndGet() > MAX_CHECKS);
        assertEquals(new CampaignRunner.RunCounts(1, 2, 0), result);
        assertTrue(checks.get() <= MAX_CHECKS, "the first row is not in the table");
        for (Thread thread : Thread.getAllStackTraces().keySet()) {
            if (thread.getName().equals("campaign")) {
                thread.join(TimeUnit.SECONDS.toMillis(10));
                assertFalse(thread.isAlive(), "the second run is still made");
            }
        }
    }

    @Test
    void theTableOfTimesHasTheSecondsAndTicksOfEachRun() throws Exception {
        long start = System.nanoTime();
        new CampaignRunner(plan("1 2 3"), new CampaignFolder(folder), Shard.ALL, 1)
                .run(false, (made, runs) -> {}, () -> false);
        double elapsed = (System.nanoTime() - start) / 1e9;
        List<List<String>> rows = rows("timing.csv").stream().map(Csv::cells).toList();
        assertEquals(
                List.of(List.of("0", "100"), List.of("1", "200"), List.of("2", "300")),
                rows.stream().map(row -> List.of(row.get(0), row.get(2))).toList());
        double seconds =
                rows.stream().mapToDouble(row -> Double.parseDouble(row.get(1))).sum();
        assertTrue(seconds > 0 && seconds < elapsed, seconds + " s of " + elapsed + " s");
    }
}
