package faultline.gui;

import java.util.Collection;
import java.util.Locale;

/**
 * Statistics of measured durations.
 *
 * @param count the number of durations
 * @param median the median, milliseconds
 * @param p99 the 99th percentile, milliseconds
 * @param longest the maximum, milliseconds
 */
public record DurationStatistics(int count, double median, double p99, double longest) {

    /** Returns the statistics of at least one duration, milliseconds. */
    public static DurationStatistics of(Collection<Double> times) {
        double[] sorted =
                times.stream().mapToDouble(Double::doubleValue).sorted().toArray();
        return new DurationStatistics(
                sorted.length,
                sorted[sorted.length / 2],
                sorted[(int) (sorted.length * 0.99)],
                sorted[sorted.length - 1]);
    }

    @Override
    public String toString() {
        return String.format(
                Locale.ROOT, "%5d times: median %5.1f, p99 %5.1f, longest %5.1f ms", count, median, p99, longest);
    }
}
