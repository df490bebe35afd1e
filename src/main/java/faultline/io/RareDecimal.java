package faultline.io;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/**
 * The shortest decimal text of any number, computed slowly. {@link Double#toString(double)} specifies this text since
 * JDK 19; before, some numbers have a digit too many, for example 2<sup>-44</sup>.
 */
final class RareDecimal {

    /** A text has at least one digit before and one after the point. */
    private static final int MIN_DIGITS = 2;

    /** The powers of ten of the first digit for which a text has no exponent. */
    private static final int MIN_PLAIN = -3;

    private static final int MAX_PLAIN = 6;

    private RareDecimal() {}

    /** Returns the text of a finite number. */
    static String text(double number) {
        String text = Double.toString(number);
        if (number == 0) {
            return text;
        }
        BigDecimal written = new BigDecimal(text).abs();
        BigDecimal shortest = shorten(Math.abs(number), written);
        return shortest.compareTo(written) == 0 ? text : (number < 0 ? "-" : "") + format(shortest);
    }

    /** Returns the nearest decimal of the fewest digits that reads back to a positive number, given one that does. */
    private static BigDecimal shorten(double number, BigDecimal written) {
        BigDecimal exact = new BigDecimal(number);
        BigDecimal shortest = written.stripTrailingZeros();
        int digits = Math.max(MIN_DIGITS, shortest.precision());
        BigDecimal next = nearest(exact, digits, number);
        while (next != null) {
            shortest = next;
            digits--;
            next = digits < MIN_DIGITS ? null : nearest(exact, digits, number);
        }
        return shortest.stripTrailingZeros();
    }

    /** Returns the decimal of some digits that is nearest to a number and reads back to it; null if there is none. */
    private static BigDecimal nearest(BigDecimal exact, int digits, double number) {
        BigDecimal rounded = exact.round(new MathContext(digits, RoundingMode.HALF_EVEN));
        if (rounded.doubleValue() == number) {
            return rounded;
        }
        // Below a power of two the next double is nearer than above it.
        BigDecimal above = exact.round(new MathContext(digits, RoundingMode.UP));
        return above.doubleValue() == number ? above : null;
    }

    private static String format(BigDecimal number) {
        int power = number.precision() - number.scale() - 1;
        if (power >= MIN_PLAIN && power <= MAX_PLAIN) {
            return number.setScale(Math.max(1, number.scale())).toPlainString();
        }
        String digits = number.unscaledValue().toString();
        return digits.charAt(0) + "." + (digits.length() == 1 ? "0" : digits.substring(1)) + "E" + power;
    }
}
