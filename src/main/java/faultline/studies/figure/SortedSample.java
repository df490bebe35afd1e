package faultline.studies.figure;

import java.util.Arrays;
import java.util.stream.DoubleStream;

/** The values of a sample in ascending order; values that are not finite are omitted. */
public final class SortedSample {

    private final double[] sorted;

    private SortedSample(double[] sorted) {
        this.sorted = sorted;
    }

    public static SortedSample of(DoubleStream values) {
        double[] sorted = values.filter(Double::isFinite).toArray();
        Arrays.sort(sorted);
        return new SortedSample(sorted);
    }

    public int size() {
        return sorted.length;
    }

    /** Returns a quantile, linearly interpolated; not a number if the sample is empty. */
    public double quantile(double share) {
        if (sorted.length == 0) {
            return Double.NaN;
        }
        double position = share * (sorted.length - 1);
        int below = (int) position;
        int above = Math.min(below + 1, sorted.length - 1);
        return sorted[below] + (position - below) * (sorted[above] - sorted[below]);
    }

    public double median() {
        return quantile(0.5);
    }

    public double min() {
        return quantile(0);
    }

    public double max() {
        return quantile(1);
    }

    /** Returns the root mean square; not a number if the sample is empty. */
    public double rms() {
        return Math.sqrt(DoubleStream.of(sorted).map(x -> x * x).average().orElse(Double.NaN));
    }

    /** Returns the number of values whose magnitude exceeds a limit. */
    public int countBeyond(double limit) {
        return (int) DoubleStream.of(sorted).filter(x -> Math.abs(x) > limit).count();
    }
}
