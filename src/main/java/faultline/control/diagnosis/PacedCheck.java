package faultline.control.diagnosis;

/**
 * A check that is made not at every tick but whenever a quantity of the robot's motion has left an interval. Each check
 * sets its next interval.
 */
abstract class PacedCheck {

    private final MotionAccumulator.Total pace;
    private double low;
    private double high;

    /** Creates a check that is due at once. */
    PacedCheck(MotionAccumulator.Total pace) {
        this.pace = pace;
        dueAtEveryTick();
    }

    /** Returns whether the quantity has left the interval. */
    final boolean isDue(MotionAccumulator motion) {
        double now = motion.total(pace);
        return now <= low || now >= high;
    }

    /** Waits until the quantity reaches one of two values, of which the first is the lower one. */
    final void waitUntil(double lower, double upper) {
        low = lower;
        high = upper;
    }

    /** Makes this check due at every tick. */
    final void dueAtEveryTick() {
        // No value lies between these bounds.
        waitUntil(Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY);
    }

    /**
     * Makes the check.
     *
     * @param readings the readings of all sensors in the robot's order
     * @param tick now
     */
    abstract void run(double[] readings, long tick);
}
