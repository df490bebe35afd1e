package faultline.campaign.run;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.PlannedRun;
import faultline.engine.metrics.Expectation;
import faultline.io.MessageText;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.ScenarioLimits;

/** Makes the scenario that replays a run of a campaign, with the same duration and trajectory hash. */
public final class ReplayScenario {

    private ReplayScenario() {}

    /**
     * {@return the scenario that replays a run; its description gives the values and the outcome of the run}
     *
     * @param plan the plan of the campaign
     * @param index the number of the run
     * @param outcome the outcome of the run
     * @param simulatedSeconds the duration of the run, seconds
     * @throws ScenarioException if the plan's values, each valid by itself, do not make a valid scenario together
     */
    public static Scenario of(CampaignPlan plan, long index, Outcome outcome, double simulatedSeconds)
            throws ScenarioException {
        PlannedRun run = plan.run(index);
        Scenario scenario = plan.scenario(run);
        return new Scenario(
                scenario.name(),
                description(plan, run, outcome),
                false,
                scenario.setup().withDuration(simulatedSeconds),
                Expectation.NONE);
    }

    private static String description(CampaignPlan plan, PlannedRun run, Outcome outcome) {
        StringBuilder text = new StringBuilder("Run " + run.index() + " of "
                + plan.header().name() + ": world " + run.world() + ", seed " + run.seed());
        for (int i = 0; i < run.cells().size(); i++) {
            if (!run.cells().get(i).isEmpty()) {
                text.append(", ")
                        .append(plan.factorColumns().get(i).name())
                        .append(' ')
                        .append(run.cells().get(i));
            }
        }
        String end = "; outcome " + outcome.word();
        int longest = ScenarioLimits.MAX_DESCRIPTION_LENGTH - end.length() - "...".length();
        return MessageText.shortened(text.toString(), longest) + end;
    }
}
