package faultline.paint.chart;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;

/**
 * One axis of a chart.
 *
 * @param label what is on it, with its unit
 * @param low the value at its beginning
 * @param high the value at its end, above low
 * @param logarithmic whether equal ways are equal ratios; low is positive then
 */
public record Axis(String label, double low, double high, boolean logarithmic) {

    private static final int MAX_INTERVALS = 8;

    public Axis {
        if (!(low < high) || logarithmic && low <= 0) {
            throw new IllegalArgumentException(
                    "an axis needs low < high, and low > 0 if it is logarithmic: " + low + ", " + high);
        }
    }

    /**
     * An axis of equal steps.
     *
     * @param label what is on it, with its unit
     * @param low the value at its beginning
     * @param high the value at its end
     * @return the axis
     */
    public static Axis linear(String label, double low, double high) {
        return new Axis(label, low, high, false);
    }

    /**
     * The axis of equal steps that shows all values and begins and ends at round ones.
     *
     * @param label what is on it, with its unit
     * @param values at least one
     * @return the axis
     */
    public static Axis covering(String label, DoubleStream values) {
        double[] all = values.filter(Double::isFinite).toArray();
        double least = Arrays.stream(all).min().orElse(0);
        double most = Arrays.stream(all).max().orElse(1);
        double step = niceStep(Math.max(most - least, 1e-9));
        double low = Math.floor(least / step) * step;
        double high = Math.ceil(most / step) * step;
        return linear(label, low, high > low ? high : low + step);
    }

    /**
     * Where a value is on the axis.
     *
     * @param value positive if the axis is logarithmic
     * @return 0 at its beginning, 1 at its end
     */
    public double fractionOf(double value) {
        if (logarithmic) {
            return StrictMath.log(value / low) / StrictMath.log(high / low);
        }
        return (value - low) / (high - low);
    }

    /**
     * The value at a place of the axis.
     *
     * @param share from 0, its beginning, to 1, its end
     * @return the value
     */
    public double valueAt(double share) {
        return logarithmic ? low * StrictMath.exp(share * StrictMath.log(high / low)) : low + share * (high - low);
    }

    /**
     * Round values along the axis.
     *
     * @return in order
     */
    public List<Double> ticks() {
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
        for (double power = powerOfTen(low); power <= high; power *= 10) {
            for (double leading : new double[] {1, 2, 5}) {
                double tick = leading * power;
                if (tick >= low * (1 - 1e-9) && tick <= high * (1 + 1e-9)) {
                    ticks.add(tick);
                }
            }
        }
        return ticks;
    }

    private static double niceStep(double span) {
        double rough = span / MAX_INTERVALS;
        double power = powerOfTen(rough);
        double leading = rough / power;
        return power * (leading <= 1 ? 1 : leading <= 2 ? 2 : leading <= 5 ? 5 : 10);
    }

    /** The power of ten at or below a positive value. */
    private static double powerOfTen(double value) {
        return Double.parseDouble("1e" + (int) Math.floor(StrictMath.log10(value) + 1e-9));
    }

    /**
     * A tick's name.
     *
     * @param tick a value
     * @return no more digits than it needs, a true minus sign
     */
    public static String formatTick(double tick) {
        BigDecimal rounded =
                new BigDecimal(tick).round(new java.math.MathContext(6)).stripTrailingZeros();
        String text = rounded.abs().compareTo(new BigDecimal("1e-9")) < 0 ? "0" : rounded.toPlainString();
        return text.replace('-', '\u2212');
    }
}
