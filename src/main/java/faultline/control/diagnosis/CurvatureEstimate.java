package faultline.control.diagnosis;

import java.util.Arrays;

/**
 * Estimates the additional curvature of the robot's path where wheels or motors of its sides differ from its model.
 * Beside a straight wall the distance r and the heading h by the model satisfy r' = -sin h, so r plus the integral of h
 * is a straight line over the distance driven; where the path has an additional curvature k, it is a parabola with
 * second derivative -k.
 */
final class CurvatureEstimate {

    /** The length of a leg, metres. The means over three legs give a sample. */
    private static final double LEG = 0.15;

    /** The number of samples whose median is used: corners and obstacles at the wall make some wrong. */
    private static final int SAMPLES = 7;

    /**
     * The maximum curvature of a sample, 1/m: wheels and a track that are each off by 5 % cause up to 0.55, and corners
     * cause more.
     */
    private static final double MAX_SAMPLE = 0.8;

    /** The estimate changes only if all samples but the least and the greatest agree within this, 1/m. */
    private static final double MAX_SPREAD = 0.25;

    /** A smaller curvature counts as none, 1/m, so that nothing changes if the model of the robot is right. */
    private static final double NEGLIGIBLE = 0.1;

    /** The maximum turn of the robot over the legs of a sample, radians. */
    private static final double MAX_TURNING = StrictMath.toRadians(20);

    /**
     * A wall is straight if the point that the sensor sees is at most this far from the line through the points that
     * others see ahead and behind, metres. On a path around a disc of 1 m the distance is 0.04.
     */
    private static final double MAX_SAG = 0.015;

    private final double[] samples = new double[SAMPLES];
    private int count;
    private double curvature;

    private final double[] means = new double[3];
    private final double[] turnings = new double[3];
    private final double[] sags = new double[3];
    private int legs;
    private double legSum;
    private double legLength;
    private int legCount;
    private double legTurning;
    private double legSag;
    private double heading;
    private double integral;

    /** Returns the additional curvature to the left, 1/m, 0 if it is negligible. */
    double curvature() {
        return curvature;
    }

    /**
     * Processes a reading after some motion.
     *
     * @param reading the reading of the sensor that faces the wall, metres
     * @param sag by how much it exceeds the distance to the line through what others see ahead and behind, metres; not
     *     a number where there is no such line
     * @param rolled by the model, metres
     * @param turned by the model, without the correction, radians
     */
    void update(double reading, double sag, double rolled, double turned) {
        if (Double.isNaN(sag)) {
            legs = 0;
            beginLeg();
            heading = 0;
            integral = 0;
            return;
        }
        heading += turned;
        integral += heading * rolled;
        legLength += Math.abs(rolled);
        legTurning += Math.abs(turned);
        legSag += sag;
        legSum += reading + integral;
        legCount++;
        if (legLength >= LEG) {
            endLeg();
        }
    }

    private void beginLeg() {
        legSum = 0;
        legLength = 0;
        legCount = 0;
        legTurning = 0;
        legSag = 0;
    }

    private void endLeg() {
        int last = legs++ % 3;
        means[last] = legSum / legCount;
        turnings[last] = legTurning;
        sags[last] = Math.abs(legSag / legCount);
        double length = legLength;
        beginLeg();
        boolean straight = Math.max(sags[0], Math.max(sags[1], sags[2])) < MAX_SAG;
        if (legs >= 3 && straight && turnings[0] + turnings[1] + turnings[2] < MAX_TURNING) {
            double bend = means[last] - 2 * means[(last + 2) % 3] + means[(last + 1) % 3];
            addSample(-bend / (length * length));
        }
    }

    private void addSample(double sample) {
        if (Math.abs(sample) > MAX_SAMPLE) {
            return;
        }
        samples[count++ % SAMPLES] = sample;
        if (count >= SAMPLES) {
            double[] sorted = samples.clone();
            Arrays.sort(sorted);
            double median = sorted[SAMPLES / 2];
            if (sorted[SAMPLES - 2] - sorted[1] < MAX_SPREAD) {
                curvature = Math.abs(median) < NEGLIGIBLE ? 0 : median;
            }
        }
    }
}
