package faultline.campaign.plan;

/**
 * The seeds of the runs of every world: {@code count} consecutive numbers.
 *
 * @param first the first seed
 * @param count the number of seeds
 */
record Seeds(long first, int count) {

    /** One run of each world, with the seed that a scenario has by default. */
    static final Seeds DEFAULT = new Seeds(1, 1);
}
