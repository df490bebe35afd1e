package faultline.paint.chart;

import faultline.paint.surface.NiceSteps;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/**
 * An axis of a chart.
 *
 * @param label its quantity and unit
 * @param low the value at its start
 * @param high the value at its end, above low
 * @param logarithmic whether the scale is logarithmic; low is positive then
 * @param rows the names of the values 0, 1, ... of an axis of rows; empty for an axis of numbers
 */
public record Axis(String label, double low, double high, boolean logarithmic, List<String> rows) {

    private static final int MAX_INTERVALS = 8;

    public Axis {
        rows = List.copyOf(rows);
        if (!(low < high) || logarithmic && low <= 0) {
            throw new IllegalArgumentException(
                    "an axis needs low < high, and low > 0 if it is logarithmic: " + low + ", " + high);
        }
    }

    /** Creates an axis of numbers. */
    public Axis(String label, double low, double high, boolean logarithmic) {
        this(label, low, high, logarithmic, List.of());
    }

    /** Returns a linear axis from {@code low} to {@code high}. */
    public static Axis linear(String label, double low, double high) {
        return new Axis(label, low, high, false);
    }

    /** Returns an axis of at least one row of equal height, the first at the start of the axis. */
    public static Axis rows(List<String> names) {
        return new Axis("", -0.5, names.size() - 0.5, false, names);
    }

    /** Returns a linear axis that includes all finite values and starts and ends at multiples of a nice step. */
    public static Axis covering(String label, DoubleStream values) {
        return covering(label, values, 0);
    }

    /**
     * Returns a linear axis that includes all finite values and starts and ends at multiples of a nice step. It starts
     * lower if the values would span less than a minimum, so that its ticks are readable. If none of them is negative,
     * it does not start below 0 and ends higher instead.
     */
    public static Axis covering(String label, DoubleStream values, double minSpan) {
        double[] all = values.filter(Double::isFinite).toArray();
        double greatest = Arrays.stream(all).max().orElse(1);
        double smallest = Arrays.stream(all).min().orElse(0);
        double lowest = Math.min(smallest, greatest - minSpan);
        boolean startsAtZero = smallest >= 0 && lowest < 0;
        double least = startsAtZero ? 0 : lowest;
        double most = startsAtZero ? minSpan : greatest;
        // Labels have twelve digits.
        double minShown = 1e-9 * Math.max(1, Math.max(Math.abs(least), Math.abs(most)));
        double step = niceStep(Math.max(most - least, minShown));
        double low = Math.floor(least / step) * step;
        double high = Math.ceil(most / step) * step;
        return linear(label, low, high > low ? high : low + step);
    }

    /**
     * Returns the position of a value, 0 at the start of the axis, 1 at its end; the value is positive if the axis is
     * logarithmic.
     */
    public double fractionOf(double value) {
        if (logarithmic) {
            return StrictMath.log(value / low) / StrictMath.log(high / low);
        }
        return (value - low) / (high - low);
    }

    /** Returns the value at a position in [0, 1]. */
    public double valueAt(double share) {
        return logarithmic ? low * StrictMath.exp(share * StrictMath.log(high / low)) : low + share * (high - low);
    }

    /** Returns nice values along the axis, or its rows, in order. */
    public List<Double> ticks() {
        if (!rows.isEmpty()) {
            return IntStream.range(0, rows.size()).mapToObj(row -> (double) row).toList();
        }
        return logarithmic ? logarithmicTicks() : linearTicks();
    }

    private List<Double> linearTicks() {
        double step = niceStep(high - low);
        List<Double> ticks = new ArrayList<>();
        for (long i = (long) Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) {
            ticks.add(i * step);
        }
        return ticks;
    }

    private List<Double> logarithmicTicks() {
        List<Double> ticks = new ArrayList<>();
        for (double power = NiceSteps.powerOfTen(low); power <= high; power *= 10) {
            for (double leading : new double[] {1, 2, 5}) {
                double tick = leading * power;
                if (tick >= low * (1 - 1e-9) && tick <= high * (1 + 1e-9)) {
                    ticks.add(tick);
                }
            }
        }
        return ticks;
    }

    /**
     * Returns every how many ticks of a linear axis there is room for a label, given their lengths along the axis in a
     * picture; 1 for a logarithmic axis and for rows.
     */
    public int labelStride(double length, double label) {
        double distance = niceStep(high - low) / (high - low) * length;
        return logarithmic || !rows.isEmpty() || distance >= label
                ? 1
                : (int) Math.ceil(label / Math.max(distance, 1e-3));
    }

    /** Returns whether a tick has a label; for a stride, these are the same values wherever the axis starts. */
    public boolean hasLabel(double tick, int stride) {
        return stride == 1 || Math.round(tick / niceStep(high - low)) % stride == 0;
    }

    private static double niceStep(double span) {
        return NiceSteps.atLeast(span / MAX_INTERVALS);
    }

    String tickLabel(double tick) {
        return rows.isEmpty() ? formatTick(tick) : rows.get((int) tick);
    }

    /** Returns the label of a number: no more digits than necessary, with a true minus sign. */
    public static String formatTick(double tick) {
        BigDecimal rounded = new BigDecimal(tick).round(new MathContext(12)).stripTrailingZeros();
        String text = rounded.abs().compareTo(new BigDecimal("1e-9")) < 0 ? "0" : rounded.toPlainString();
        return text.replace('-', '\u2212');
    }
}
