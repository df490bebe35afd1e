package faultline.gui;

import java.util.Collection;
import java.util.Locale;

/**
 * What a handful of measured times come to.
 *
 * @param count how many there are
 * @param median of them, milliseconds
 * @param p99 of a hundred times one is longer, milliseconds
 * @param longest of them, milliseconds
 */
public record DurationStatistics(int count, double median, double p99, double longest) {

    /** Of at least one time, milliseconds. */
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
