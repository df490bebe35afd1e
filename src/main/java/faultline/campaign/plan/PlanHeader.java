package faultline.campaign.plan;

/**
 * What a plan's root element and description say.
 *
 * @param name for people
 * @param description for people
 * @param seed of everything that is drawn
 * @param latin whether draws are a Latin hypercube over all blocks
 * @param untilVerdict whether a run ends as soon as it is known whether the robot carries on
 */
public record PlanHeader(String name, String description, long seed, boolean latin, boolean untilVerdict) {}
