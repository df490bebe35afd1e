package faultline.campaign.plan;

/** The seeds of the runs of every world: {@code count} consecutive numbers from {@code first} on. */
record Seeds(long first, int count) {

    /** One run of each world, with the seed that a scenario has by default. */
    static final Seeds DEFAULT = new Seeds(1, 1);
}
