package faultline.control;

/**
 * Learns how noisy a sensor's readings are. The third difference of four readings is all but free of smooth motion, be it as quick as a
 * spin past a wall, and its variance is twenty times the noise's: 1 + 9 + 9 + 1.
 */
final class NoiseMeter {

    /** A third difference beyond this is no noise but something else coming into sight, metres. */
    private static final double JUMP = 0.08;
    private static final double GAIN = 20;

    /** How many readings are looked back on in the long run. */
    private static final double MEMORY = 100;

    private double variance;
    private double count;
    private double previous = Double.NaN;
    private double previousFirst = Double.NaN;
    private double previousSecond = Double.NaN;

    /** Takes a reading, which may be infinite for nothing. */
    void learn(double reading) {
        double first = reading - previous;
        double second = first - previousFirst;
        double third = second - previousSecond;
        if (Math.abs(third) < JUMP) {
            count = Math.min(MEMORY, count + 1);
            variance += (third * third / GAIN - variance) / count;
        }
        previous = reading;
        previousFirst = first;
        previousSecond = second;
    }

    /** The standard deviation of the noise as far as it has shown, metres. */
    double deviation() {
        return Math.sqrt(variance);
    }
}
