package faultline.control.wallfollower;

/**
 * Estimates the noise of a sensor's readings. The third difference of four readings is almost independent of smooth
 * motion, even in a spin past a wall, and its variance is twenty times that of the noise: 1 + 9 + 9 + 1.
 *
 * <p>Because third differences beyond a threshold are left out, those of strong noise are, too, and its estimate is too
 * small: noise of 4, 8, 10, 15, 20 and 50 mm is estimated as 4.0, 7.4, 8.3, 9.4, 9.8 and 10.3 mm. No noise gives more
 * than about 0.08 m / sqrt(3 * 20) = 10.3 mm. Five estimated standard deviations, as in {@link EqualReadingsEdgeTimer},
 * are then 4.2 true ones at 10 mm and 2.4 at 20 mm, so noise is more often taken for an edge.
 */
final class NoiseEstimator {

    /** A third difference beyond this is not noise but another object that comes into sight, metres. */
    private static final double OUTLIER_THRESHOLD = 0.08;

    private static final double VARIANCE_GAIN = 20;

    /** The number of past readings that count. */
    private static final double MAX_COUNT = 100;

    /** The number of third differences from which the estimate is used. */
    private static final double MIN_COUNT = 8;

    private double variance;
    private double count;
    private double previous = Double.NaN;
    private double previousFirstDifference = Double.NaN;
    private double previousSecondDifference = Double.NaN;

    /** Processes a reading; infinite if the sensor sees nothing. */
    void update(double reading) {
        double first = reading - previous;
        double second = first - previousFirstDifference;
        double third = second - previousSecondDifference;
        if (Math.abs(third) < OUTLIER_THRESHOLD) {
            count = Math.min(MAX_COUNT, count + 1);
            variance += (third * third / VARIANCE_GAIN - variance) / count;
        }
        previous = reading;
        previousFirstDifference = first;
        previousSecondDifference = second;
    }

    /** Returns the estimated standard deviation of the noise, metres. */
    double standardDeviation() {
        return Math.sqrt(variance);
    }

    /** Returns whether there have been enough readings for an estimate. */
    boolean isKnown() {
        return count >= MIN_COUNT;
    }
}
