package faultline.control.diagnosis;

/**
 * How often the sensors are inspected. The fewer the inspections, the more each one counts, so that counts grow and
 * decay at the same rate over time.
 */
enum InspectionRate {
    /** While something is suspicious or a surface is near. */
    FULL(1, 5, 12, 24),
    /** While nothing is suspicious, but the robot turns, a reading has just jumped, or a surface may be ahead. */
    REDUCED(3, 2, 4, 8),
    /** While nothing is suspicious and the robot drives straight on. */
    STRAIGHT(8, 1, 2, 3);

    /** The number of times that a measurement is tested again. */
    static final int RETESTS = 3;

    /** The share of each count that remains after the time between two inspections at the full rate. */
    private static final double FADE = 0.97;

    private final int interval;
    private final double fade;
    private final int[] retests;

    InspectionRate(int interval, int... retests) {
        this.interval = interval;
        this.fade = StrictMath.pow(FADE, interval);
        this.retests = retests;
    }

    /**
     * Returns the time between two inspections, as a multiple of that at the full rate; also the weight of each
     * inspection.
     */
    int interval() {
        return interval;
    }

    /** Returns the share of each count that remains after an inspection. */
    double fade() {
        return fade;
    }

    /**
     * Returns after how many inspections a measurement is tested again, because there is more free-space evidence by
     * then.
     *
     * @param index which of the tests, less than {@link #RETESTS}
     */
    int retest(int index) {
        return retests[index];
    }
}
