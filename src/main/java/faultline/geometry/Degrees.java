package faultline.geometry;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;

/**
 * Converts between degrees, used in files and windows, and radians, used in the code. Both conversions are correctly
 * rounded, and the text of an angle reads back to the same bits, so that a saved run replays exactly.
 */
public final class Degrees {

    private static final BigDecimal PI = new BigDecimal("3.14159265358979323846264338327950288419716939937510");
    private static final BigDecimal HALF_TURN = BigDecimal.valueOf(180);
    private static final int MAX_DIGITS = 25;

    /** The radians of the first angles that were converted; large files repeat a few, and a conversion is slow. */
    static final Map<BigDecimal, Double> KNOWN_RADIANS = new ConcurrentHashMap<>();

    private static final int MAX_KNOWN = 1000;

    private Degrees() {}

    /**
     * {@return the number of radians nearest to a finite double, rounded to the fewest digits that give the same
     * double} This is the result for the text 0.1 if the double is 0.1. It does not depend on the JDK, while
     * {@link Double#toString(double)} does.
     *
     * @param degrees the number of degrees, finite
     */
    public static double toRadians(double degrees) {
        return toRadians(shortest(new BigDecimal(degrees), rounded -> rounded.doubleValue() == degrees));
    }

    /**
     * {@return the number of radians nearest to a decimal number of degrees}
     *
     * @param degrees the number of degrees
     */
    public static double toRadians(BigDecimal degrees) {
        Double known = KNOWN_RADIANS.get(degrees);
        if (known != null) {
            return known;
        }
        double radians = convert(degrees);
        if (KNOWN_RADIANS.size() < MAX_KNOWN) {
            KNOWN_RADIANS.put(degrees, radians);
        }
        return radians;
    }

    private static double convert(BigDecimal degrees) {
        return degrees.multiply(PI)
                .divide(HALF_TURN, new MathContext(50, RoundingMode.HALF_EVEN))
                .doubleValue();
    }

    /**
     * {@return the shortest decimal text, in degrees and without exponent, that {@link #toRadians(BigDecimal)} converts
     * back to the same finite number of radians}
     *
     * @param radians the number of radians, finite
     */
    public static String toText(double radians) {
        BigDecimal exact =
                new BigDecimal(radians).multiply(HALF_TURN).divide(PI, new MathContext(40, RoundingMode.HALF_EVEN));
        BigDecimal degrees = shortest(exact, rounded -> convert(rounded) == radians);
        return degrees.signum() == 0 ? "0" : degrees.stripTrailingZeros().toPlainString();
    }

    /** Returns a number rounded to as few digits as a condition allows, or the number itself. */
    private static BigDecimal shortest(BigDecimal exact, Predicate<BigDecimal> condition) {
        for (int digits = 1; digits < MAX_DIGITS; digits++) {
            BigDecimal rounded = exact.round(new MathContext(digits, RoundingMode.HALF_EVEN));
            if (condition.test(rounded)) {
                return rounded;
            }
        }
        return exact;
    }
}
