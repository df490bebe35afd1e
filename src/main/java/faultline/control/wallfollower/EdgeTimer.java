package faultline.control.wallfollower;

import faultline.control.TimingRule;

/**
 * Times a spin past a wall: when the left sensor comes to it (frame F3), when it leaves it (F4), and how long to turn
 * back, t_p = t_D / 2 (eq. (4) of the paper). The {@link TimingRule} defines at which readings the two moments are
 * taken.
 *
 * <p>Time is that of the spin clock, which runs as fast as the robot turns, in units of the constant rate, so that the
 * result does not depend on the acceleration of the spin.
 */
abstract sealed class EdgeTimer permits RangeEdgeTimer, EqualReadingsEdgeTimer {

    private double tF3 = Double.NaN;
    private double tF4 = Double.NaN;

    /** Creates a timer for a rule. */
    static EdgeTimer of(TimingRule rule) {
        return switch (rule) {
            case RANGE -> new RangeEdgeTimer();
            case EQUAL_READINGS -> new EqualReadingsEdgeTimer();
        };
    }

    /**
     * Starts a new spin.
     *
     * @param margin the difference between the timing level and the nearest reading, as a share of that reading
     * @param noise the standard deviation of the readings' noise, metres
     * @param known whether the noise is known; otherwise {@link #updateNoise} sets it during the spin
     * @param step the turn between two readings, radians
     */
    void start(double margin, double noise, boolean known, double step) {
        setEdges(Double.NaN, Double.NaN);
    }

    /** Sets the noise of a sensor that had seen nothing before the spin, as soon as it is known. */
    abstract void updateNoise(double noise, boolean known);

    /**
     * Adds a sample before the sensor has come to the wall. The distance that the robot still rolls forwards may bring
     * a wall nearer; this is not counted as a fall of the reading.
     */
    abstract void addApproachSample(double clock, double reading, double rolled);

    /** Returns whether the sensor comes to a wall. */
    abstract boolean reachesWall();

    /** Adds a sample while the sensor passes the wall. */
    abstract void addPassSample(double clock, double reading);

    /** Returns whether the sensor has left the wall, so that F3 and F4 are known. */
    abstract boolean leavesWall();

    /** Sets the moments of F3 and F4, seconds on the spin clock. */
    final void setEdges(double newF3, double newF4) {
        tF3 = newF3;
        tF4 = newF4;
    }

    /** Returns the moment of frame F3, seconds on the spin clock; not a number before it. */
    final double tF3() {
        return tF3;
    }

    /** Returns the moment of frame F4, seconds on the spin clock; not a number before it. */
    final double tF4() {
        return tF4;
    }

    /**
     * Returns how long to turn back from F4, seconds. It is negative if F3 and F4 lie in the part of the spin in which
     * the robot still turned to the left, as with random readings: the spin clock runs backwards there.
     */
    final double tP() {
        double tD = tF4 - tF3;
        return tD / 2; // eq. (4): t_p = t_D / 2
    }
}
