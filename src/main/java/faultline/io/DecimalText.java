package faultline.io;

import faultline.geometry.Degrees;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.regex.Pattern;

/**
 * Decimal numbers in files, in the same form on every machine. Reading a number that this class has written gives the
 * same bits.
 */
public final class DecimalText {

    private static final Pattern DECIMAL =
            Pattern.compile("[+-]?(?:\\d++(?:\\.\\d*+)?+|\\.\\d++)(?:[eE][+-]?\\d{1,4})?+");
    /** The maximum length of the text; no double needs as many characters. */
    private static final int MAX_LENGTH = 1200;
    /** Numbers beyond this power of ten are written with an exponent. */
    private static final int MAX_PLAIN_EXPONENT = 15;

    /** The digits of a rounded number. */
    private static final int ROUNDED_DIGITS = 3;

    /** The digits with which every number differs from all others. */
    private static final int MAX_DIGITS = 17;

    /** A number with so many digits, or fewer and a point, is short. */
    public static final int MAX_SHORT_LENGTH = 15;

    /** All values are exact. */
    private static final double[] POWERS_OF_TEN = {
        1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14
    };

    /** A minus sign before a number all of whose digits are zero. */
    private static final Pattern SIGN_OF_ZERO = Pattern.compile("(?<![\\w.])-(?=0(?:\\.0*+)?(?![.\\d]))");

    private DecimalText() {}

    /**
     * {@return the exact value of a decimal number with or without exponent, empty if the text is not a number}
     * Surrounding blanks are ignored.
     *
     * @param text the text
     */
    public static Optional<BigDecimal> parse(String text) {
        String trimmed = XmlText.strip(text);
        if (trimmed.length() > MAX_LENGTH
                || !isPlain(trimmed) && !DECIMAL.matcher(trimmed).matches()) {
            return Optional.empty();
        }
        return Optional.of(new BigDecimal(trimmed));
    }

    /**
     * {@return the value of a whole number of 64 bits, in the digits 0 to 9 with an optional sign; empty if the text is
     * no such number} Surrounding blanks are ignored.
     *
     * @param text the text
     */
    public static OptionalLong parseWhole(String text) {
        String trimmed = XmlText.strip(text);
        try {
            // The JDK also reads the digits of other scripts.
            return trimmed.chars().allMatch(c -> c < 128)
                    ? OptionalLong.of(Long.parseLong(trimmed))
                    : OptionalLong.empty();
        } catch (NumberFormatException e) {
            return OptionalLong.empty();
        }
    }

    /**
     * {@return the nearest double to a number that is written with at most 15 digits and without exponent; NaN for any
     * other text} This is fast.
     *
     * @param text the text
     */
    public static double parseShort(String text) {
        boolean negative = text.startsWith("-");
        int begin = negative ? 1 : 0;
        int point = -1;
        long digits = 0;
        for (int i = begin; i < text.length(); i++) {
            char c = text.charAt(i);
            if (c == '.' && point < 0 && i > begin) {
                point = i;
            } else if (c >= '0' && c <= '9' && i < begin + MAX_SHORT_LENGTH) {
                digits = 10 * digits + c - '0';
            } else {
                return Double.NaN;
            }
        }
        if (begin == text.length()) {
            return Double.NaN;
        }
        double size = shift(digits, point < 0 ? 0 : text.length() - point - 1);
        return negative ? -size : size;
    }

    /**
     * {@return the nearest double to a number of at most 15 digits} It is correctly rounded because digits and power of
     * ten are both exact doubles.
     *
     * @param digits the digits, without a point
     * @param decimals the number of digits after the point
     */
    public static double shift(long digits, int decimals) {
        return digits / POWERS_OF_TEN[decimals];
    }

    /** Returns whether a text is digits with at most one point after the first; most numbers are, and this is fast. */
    private static boolean isPlain(String text) {
        boolean point = false;
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            boolean firstPoint = c == '.' && i > 0 && !point;
            point |= firstPoint;
            if (!firstPoint && (c < '0' || c > '9')) {
                return false;
            }
        }
        return !text.isEmpty();
    }

    /**
     * {@return the nearest double to a number; a zero keeps the sign of its text} Infinite if the number is beyond all
     * doubles.
     *
     * @param exact the result of {@link #parse} for the same text
     * @param text the text of the number
     */
    public static double toDouble(BigDecimal exact, String text) {
        return withSignOf(exact.doubleValue(), text);
    }

    /**
     * {@return an angle given in degrees in radians; a zero keeps the sign of its text}
     *
     * @param degrees the exact value of the text
     * @param text the text of the angle, in degrees
     */
    public static double toRadians(BigDecimal degrees, String text) {
        return withSignOf(Degrees.toRadians(degrees), text);
    }

    private static double withSignOf(double value, String text) {
        return value == 0 && XmlText.strip(text).startsWith("-") ? -0.0 : value;
    }

    /**
     * {@return the text of a finite number, with an exponent only if the number is very large or very small}
     *
     * @param value the number, finite
     */
    public static String format(double value) {
        if (value == 0) {
            return formatZero(value);
        }
        String text = ShortestDecimal.text(value);
        if (text.indexOf('E') < 0) {
            return withoutTrailingZeros(text);
        }
        BigDecimal shortest = new BigDecimal(text).stripTrailingZeros();
        int power = shortest.precision() - shortest.scale();
        return Math.abs(power) <= MAX_PLAIN_EXPONENT ? shortest.toPlainString() : shortest.toString();
    }

    /** Returns a number with a point as decimal arithmetic would write it, which takes several times as long. */
    private static String withoutTrailingZeros(String text) {
        int end = text.length();
        while (text.charAt(end - 1) == '0') {
            end--;
        }
        return text.substring(0, text.charAt(end - 1) == '.' ? end - 1 : end);
    }

    /**
     * {@return the text of a number rounded to three digits}
     *
     * @param value the number
     */
    public static String formatRounded(double value) {
        return formatRounded(value, ROUNDED_DIGITS);
    }

    private static String formatRounded(double value, int digits) {
        return new BigDecimal(value)
                .round(new MathContext(digits))
                .stripTrailingZeros()
                .toPlainString();
    }

    /**
     * {@return the text of a number that a limit refuses, rounded to three digits, or to as many as show that it is not
     * within the limit}
     *
     * @param value the number
     * @param limit the limit
     */
    public static String formatRefused(double value, double limit) {
        for (int digits = ROUNDED_DIGITS; digits < MAX_DIGITS; digits++) {
            String rounded = formatRounded(value, digits);
            if (Double.compare(Double.parseDouble(rounded), limit) == Double.compare(value, limit)) {
                return rounded;
            }
        }
        return format(value);
    }

    /**
     * {@return the text of a number with a fixed number of decimals; a negative number that is rounded to zero has no
     * sign}
     *
     * @param value the number
     * @param decimals the number of decimals
     */
    public static String formatFixed(double value, int decimals) {
        return withoutSignOfZero(String.format(Locale.ROOT, "%." + decimals + "f", value));
    }

    /**
     * {@return a text without the minus signs of the numbers in it that are zero, such as {@code -0.00}}
     *
     * @param text a text with numbers that were formatted
     */
    public static String withoutSignOfZero(String text) {
        return SIGN_OF_ZERO.matcher(text).replaceAll("");
    }

    /**
     * {@return the text of a finite angle in degrees, without exponent}
     *
     * @param radians the angle, in radians, finite
     */
    public static String formatDegrees(double radians) {
        return radians == 0 ? formatZero(radians) : Degrees.toText(radians);
    }

    private static String formatZero(double value) {
        return Double.doubleToRawLongBits(value) == 0 ? "0" : "-0";
    }
}
