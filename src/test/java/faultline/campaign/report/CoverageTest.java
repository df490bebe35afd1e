package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.SamplePlan;
import faultline.scenario.xml.ScenarioException;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The intervals hold the true value in about nineteen of twenty simulated campaigns in which the runs of a world are
 * correlated, however few worlds there are.
 */
class CoverageTest {

    private static final int CAMPAIGNS = 400;
    private static final int RUNS = 10;
    private static final List<String> HEADER =
            List.of("run", "block", "world", "speed", "carried_on", "trajectory_hash");

    private final Random random = new Random(1);

    /** The mean of this share over worlds is 0.7, and its deviation is 0.2. */
    private double drawShare() {
        return random.nextDouble() < 0.5 ? 0.9 : 0.5;
    }

    /** Returns a campaign with a slow and a fast run in each block; the shares of their levels are independent. */
    private CampaignRuns simulate(CampaignPlan plan, int worlds) {
        List<List<String>> lines = new ArrayList<>(List.of(HEADER));
        for (int world = 0; world < worlds; world++) {
            double slow = drawShare();
            double fast = drawShare();
            for (int run = 0; run < RUNS; run++) {
                addRun(lines, world * RUNS + run, world, "0.2", slow);
                addRun(lines, world * RUNS + run, world, "0.3", fast);
            }
        }
        return new CampaignRuns(plan, lines);
    }

    private void addRun(List<List<String>> lines, int block, int world, String speed, double share) {
        String run = Integer.toString(lines.size() - 1);
        String carriedOn = random.nextDouble() < share ? "1" : "0";
        lines.add(List.of(run, Integer.toString(block), "room " + world, speed, carriedOn, run));
    }

    private static CampaignPlan plan(int worlds) throws ScenarioException {
        return SamplePlan.read(SamplePlan.text(
                "",
                "<worlds><rooms count=\"" + worlds + "\"/></worlds><seeds count=\"" + RUNS + "\"/>"
                        + "<set attribute=\"robot/@speed\" value=\"0.2 0.3\" name=\"speed\"/>"));
    }

    @ParameterizedTest
    @CsvSource({"2", "3", "5", "10"})
    void intervalsHoldTheTrueValueWithFewWorldsToo(int worlds) throws ScenarioException {
        CampaignPlan plan = plan(worlds);
        int shares = 0;
        int differences = 0;
        for (int campaign = 0; campaign < CAMPAIGNS; campaign++) {
            CampaignRuns runs = simulate(plan, worlds);
            Comparison comparison = new Comparison(runs, plan.factors().get(0));
            List<RunRow> all = runs.rows();
            List<RunRow> slow = comparison.levels(all).get("0.2");
            List<RunRow> fast = comparison.levels(all).get("0.3");
            shares += holds(Survival.of(slow).interval(), 0.7);
            differences += holds(comparison.survival(slow, fast).orElseThrow().interval(), 0);
        }
        String found = shares + " shares and " + differences + " differences of " + CAMPAIGNS;
        assertTrue(shares > 0.92 * CAMPAIGNS && differences > 0.92 * CAMPAIGNS, found);
    }

    private static int holds(Interval interval, double value) {
        return interval.low() <= value && value <= interval.high() ? 1 : 0;
    }
}
