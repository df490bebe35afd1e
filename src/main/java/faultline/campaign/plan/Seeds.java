package faultline.campaign.plan;

/**
 * The seeds that every world is run with: {@code count} successive numbers.
 *
 * @param first the first seed
 * @param count how many
 */
record Seeds(long first, int count) {

    /** One run of each world, with the seed that a scenario has by default. */
    static final Seeds DEFAULT = new Seeds(1, 1);
}
