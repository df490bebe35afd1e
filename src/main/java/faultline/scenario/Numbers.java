package faultline.scenario;

import faultline.geometry.Degrees;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * Numbers as files write them, whatever the language of the machine. Every text that this writes reads back to the same bits.
 */
public final class Numbers {

    private static final Pattern DECIMAL = Pattern.compile("[+-]?(?:\\d++(?:\\.\\d*+)?+|\\.\\d++)(?:[eE][+-]?\\d{1,4})?+");
    /** More than any double needs, and few enough to be read at once. */
    private static final int LONGEST = 1200;
    /** Outside of these powers of ten a plain number is harder to read than one with an exponent. */
    private static final int PLAIN_POWERS = 15;

    private Numbers() {
    }

    /**
     * Reads a decimal number, with or without exponent.
     *
     * @param text blanks about it are ignored
     * @return empty where it is no number; never infinite by rounding, because it is exact
     */
    public static Optional<BigDecimal> parse(String text) {
        String trimmed = text.strip();
        if (trimmed.length() > LONGEST || !DECIMAL.matcher(trimmed).matches()) {
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
    static double toDouble(BigDecimal exact, String text) {
        return signed(exact.doubleValue(), text);
    }

    /** An angle given in degrees, in radians; a zero keeps the sign of its text. */
    static double toRadians(BigDecimal degrees, String text) {
        return signed(Degrees.toRadians(degrees), text);
    }

    private static double signed(double value, String text) {
        return value == 0 && text.strip().startsWith("-") ? -0.0 : value;
    }

    /**
     * Writes a number.
     *
     * @param value finite
     * @return without exponent where that is not absurdly long
     */
    public static String toText(double value) {
        if (value == 0) {
            return zero(value);
        }
        BigDecimal shortest = new BigDecimal(Double.toString(value)).stripTrailingZeros();
        int power = shortest.precision() - shortest.scale();
        return Math.abs(power) <= PLAIN_POWERS ? shortest.toPlainString() : shortest.toString();
    }

    /** Writes a number for people, to three digits. */
    static String toRoughText(double value) {
        return new BigDecimal(value).round(new MathContext(3)).stripTrailingZeros().toPlainString();
    }

    /**
     * Writes an angle in degrees.
     *
     * @param radians finite
     * @return degrees without exponent
     */
    public static String toDegreesText(double radians) {
        return radians == 0 ? zero(radians) : Degrees.toText(radians);
    }

    private static String zero(double value) {
        return Double.doubleToRawLongBits(value) == 0 ? "0" : "-0";
    }
}
