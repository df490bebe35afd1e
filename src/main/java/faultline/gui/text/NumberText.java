package faultline.gui.text;

import faultline.io.DecimalText;
import java.math.BigDecimal;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Locale;

/** Formats numbers for users. They have a decimal point in every language, and zero has no sign. */
public final class NumberText {

    /** The decimals of the shortest tick. */
    private static final int MAX_TIME_DECIMALS = 5;

    private static final int CLOCK_DECIMALS = 3;

    private NumberText() {}

    /** Returns a text with a pattern of {@link String#format}. */
    public static String format(String pattern, Object... values) {
        return DecimalText.withoutSignOfZero(String.format(Locale.ROOT, pattern, values));
    }

    /** Returns a time of a run, seconds, with the decimals that tell its ticks apart, given the length of a tick. */
    public static String seconds(double time, double dt) {
        return format("%." + decimals(dt) + "f", time);
    }

    /** Returns a time as {@link #seconds} does, with at least the three decimals of a clock. */
    public static String clock(double time, double dt) {
        return format("%." + Math.max(CLOCK_DECIMALS, decimals(dt)) + "f", time);
    }

    /** Returns the decimals of the times of a run, at least two, given the length of a tick, seconds. */
    public static int decimals(double dt) {
        int exact = BigDecimal.valueOf(dt).stripTrailingZeros().scale();
        return Math.max(2, Math.min(MAX_TIME_DECIMALS, exact));
    }

    /** Returns a number with a pattern of {@link DecimalFormat}, as a field shows it, such as {@code 0.00##}. */
    public static String ofPattern(String pattern, double value) {
        return DecimalText.withoutSignOfZero(
                new DecimalFormat(pattern, DecimalFormatSymbols.getInstance(Locale.ROOT)).format(value));
    }

    /** Returns a number with a pattern of {@link String#format}, or a dash for NaN. */
    public static String formatOrDash(String pattern, double value) {
        return Double.isNaN(value) ? "–" : format(pattern, value);
    }
}
