package faultline.campaign.plan;

/**
 * The attributes of a plan's root element, and its description.
 *
 * @param name the name, for people
 * @param description the description, for people
 * @param seed the seed of everything that is drawn
 * @param latin whether draws are a Latin hypercube over all blocks
 * @param untilVerdict whether a run ends as soon as it is known whether the robot carries on
 */
public record PlanHeader(String name, String description, long seed, boolean latin, boolean untilVerdict) {}
