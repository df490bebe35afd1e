package faultline.control.wallfollower;

/**
 * Learns how noisy a sensor's readings are. The third difference of four readings is all but free of smooth motion, be
 * it as quick as a spin past a wall, and its variance is twenty times the noise's: 1 + 9 + 9 + 1.
 */
final class NoiseEstimator {

    /** A third difference beyond this is no noise but something else coming into sight, metres. */
    private static final double OUTLIER_THRESHOLD = 0.08;

    private static final double VARIANCE_GAIN = 20;

    /** How many readings are looked back on in the long run. */
    private static final double MAX_COUNT = 100;

    /** The number of third differences from which the estimate is used. */
    private static final double MIN_COUNT = 8;

    private double variance;
    private double count;
    private double previous = Double.NaN;
    private double previousFirstDifference = Double.NaN;
    private double previousSecondDifference = Double.NaN;

    /** Takes a reading, which may be infinite for nothing. */
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

    /** The standard deviation of the noise as far as it has shown, metres. */
    double standardDeviation() {
        return Math.sqrt(variance);
    }

    /** Returns whether there have been enough readings for an estimate. */
    boolean isKnown() {
        return count >= MIN_COUNT;
    }
}
