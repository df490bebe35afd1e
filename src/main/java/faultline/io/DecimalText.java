package faultline.io;

import faultline.geometry.Degrees;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * Numbers as files write them, whatever the language of the machine. Every text that this writes reads back to the same
 * bits.
 */
public final class DecimalText {

    private static final Pattern DECIMAL =
            Pattern.compile("[+-]?(?:\\d++(?:\\.\\d*+)?+|\\.\\d++)(?:[eE][+-]?\\d{1,4})?+");
    /** More than any double needs, and few enough to be read at once. */
    private static final int MAX_LENGTH = 1200;
    /** Outside of these powers of ten a plain number is harder to read than one with an exponent. */
    private static final int MAX_PLAIN_EXPONENT = 15;

    private DecimalText() {}

    /**
     * Reads a decimal number, with or without exponent.
     *
     * @param text blanks about it are ignored
     * @return empty where it is no number; never infinite by rounding, because it is exact
     */
    public static Optional<BigDecimal> parse(String text) {
        String trimmed = text.strip();
        if (trimmed.length() > MAX_LENGTH || !DECIMAL.matcher(trimmed).matches()) {
            return Optional.empty();
        }
        return Optional.of(new BigDecimal(trimmed));
    }

    /**
     * The nearest double to a decimal number; a zero keeps the sign of its text.
     *
     * @param exact from {@link #parse} of the same text
     * @param text what it was read from
     * @return finite unless the number is beyond all doubles
     */
    public static double toDouble(BigDecimal exact, String text) {
        return withSignOf(exact.doubleValue(), text);
    }

    /** An angle given in degrees, in radians; a zero keeps the sign of its text. */
    public static double toRadians(BigDecimal degrees, String text) {
        return withSignOf(Degrees.toRadians(degrees), text);
    }

    private static double withSignOf(double value, String text) {
        return value == 0 && text.strip().startsWith("-") ? -0.0 : value;
    }

    /**
     * Writes a number.
     *
     * @param value finite
     * @return without exponent where that is not absurdly long
     */
    public static String format(double value) {
        if (value == 0) {
            return formatZero(value);
        }
        BigDecimal shortest = new BigDecimal(Double.toString(value)).stripTrailingZeros();
        int power = shortest.precision() - shortest.scale();
        return Math.abs(power) <= MAX_PLAIN_EXPONENT ? shortest.toPlainString() : shortest.toString();
    }

    /** Writes a number for people, to three digits. */
    public static String formatRounded(double value) {
        return new BigDecimal(value)
                .round(new MathContext(3))
                .stripTrailingZeros()
                .toPlainString();
    }

    /**
     * Writes an angle in degrees.
     *
     * @param radians finite
     * @return degrees without exponent
     */
    public static String formatDegrees(double radians) {
        return radians == 0 ? formatZero(radians) : Degrees.toText(radians);
    }

    private static String formatZero(double value) {
        return Double.doubleToRawLongBits(value) == 0 ? "0" : "-0";
    }
}
