package faultline.paint.chart;

import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;

/** A chart of the frequencies of values, with bars of equal width. */
public final class Histogram {

    private static final int MIN_BARS = 5;
    private static final int MAX_BARS = 40;

    /** The minimum value at the top, so that all ticks are whole numbers. */
    private static final double MIN_HEIGHT = 5;

    /** The minimum length of the axis of values, as a share of the greatest one. */
    private static final double MIN_RELATIVE_SPAN = 0.05;
    /** The minimum length of that axis, in the unit of the values. */
    private static final double MIN_SPAN = 1e-3;

    private Histogram() {}

    /**
     * Returns the chart of some finite values, given its title, the quantity of the values with its unit, and that
     * which the bars count.
     */
    public static Chart chart(String title, String quantity, String frequency, double[] values) {
        double high = Arrays.stream(values).max().orElse(0);
        double minSpan = Math.max(MIN_SPAN, MIN_RELATIVE_SPAN * Math.abs(high));
        Axis x = Axis.covering(quantity, Arrays.stream(values), minSpan);
        long[] counts = counts(x, values);
        double highest = Arrays.stream(counts).max().orElse(1);
        Axis y = Axis.covering(frequency, DoubleStream.of(0, Math.max(MIN_HEIGHT, highest)));
        List<Vector2> upper = new ArrayList<>();
        for (int i = 0; i < counts.length; i++) {
            upper.add(new Vector2(x.valueAt((double) i / counts.length), counts[i]));
            upper.add(new Vector2(x.valueAt((i + 1.0) / counts.length), counts[i]));
        }
        List<Vector2> lower = List.of(new Vector2(x.low(), 0), new Vector2(x.high(), 0));
        List<Vector2> outline = new ArrayList<>(upper);
        outline.add(0, new Vector2(x.low(), 0));
        outline.add(new Vector2(x.high(), 0));
        return new Chart(title, x, y, List.of(new Series.Band("", upper, lower, 0), new Series.Line("", outline, 0)));
    }

    /** Returns how many values each bar has; the last one includes its upper bound. */
    static long[] counts(Axis x, double[] values) {
        int bars = (int) Math.max(MIN_BARS, Math.min(MAX_BARS, Math.ceil(2 * Math.cbrt(values.length))));
        long[] counts = new long[bars];
        for (double value : values) {
            counts[(int) Math.min(bars - 1L, (long) (bars * x.fractionOf(value)))]++;
        }
        return counts;
    }
}
