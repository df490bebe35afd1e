package faultline.campaign.plan;

/**
 * One column of {@code runs.csv}, as the data dictionary describes it.
 *
 * @param name lower_snake, with its unit at the end
 * @param unit such as "m", "deg" or "s"; empty for a text or a number without unit
 * @param meaning one sentence
 */
public record Column(String name, String unit, String meaning) {}
