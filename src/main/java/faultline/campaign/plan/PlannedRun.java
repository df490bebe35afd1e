package faultline.campaign.plan;

import java.util.List;

/**
 * One run of a plan.
 *
 * @param index its number in the plan, from 0
 * @param block the number of its world, seed and draws, from 0
 * @param world the name of its world
 * @param seed the seed of its simulation
 * @param cells the values of its factors, in the order of {@link CampaignPlan#factorColumns()}
 */
public record PlannedRun(long index, long block, String world, long seed, List<String> cells) {

    /**
     * Creates a run from a copy of the cells.
     *
     * @param index its number in the plan, from 0
     * @param block the number of its world, seed and draws, from 0
     * @param world the name of its world
     * @param seed the seed of its simulation
     * @param cells the values of its factors, in the order of {@link CampaignPlan#factorColumns()}
     */
    public PlannedRun {
        cells = List.copyOf(cells);
    }
}
