package faultline.control;

/**
 * Learns how noisy a sensor's readings are. The second difference of three readings is all but free of smooth motion, and its variance is six times the noise's.
 */
final class NoiseMeter {

    /** A second difference beyond this is no noise but something else coming into sight, metres. */
    private static final double JUMP = 0.05;

    /** How many readings are looked back on in the long run. */
    private static final double MEMORY = 100;

    private double variance;
    private double count;
    private double previous = Double.NaN;
    private double beforePrevious = Double.NaN;

    /** Takes a reading, which may be infinite for nothing. */
    void learn(double reading) {
        double second = reading - 2 * previous + beforePrevious;
        if (Math.abs(second) < JUMP) {
            count = Math.min(MEMORY, count + 1);
            variance += (second * second / 6 - variance) / count;
        }
        beforePrevious = previous;
        previous = reading;
    }

    /** The standard deviation of the noise as far as it has shown, metres. */
    double deviation() {
        return Math.sqrt(variance);
    }
}
