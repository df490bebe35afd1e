package faultline.geometry;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/**
 * Degrees, as files and windows show them, and radians, as the code has them. Both ways are correctly rounded, and the
 * text of an angle reads back to the same bits: a saved run replays exactly.
 */
public final class Degrees {

    private static final BigDecimal PI = new BigDecimal("3.14159265358979323846264338327950288419716939937510");
    private static final BigDecimal HALF_TURN = BigDecimal.valueOf(180);
    private static final int MAX_DIGITS = 25;

    private Degrees() {}

    /**
     * An angle in radians.
     *
     * @param degrees finite
     * @return the nearest number of radians
     */
    public static double toRadians(double degrees) {
        return toRadians(new BigDecimal(Double.toString(degrees)));
    }

    /**
     * An angle in radians.
     *
     * @param degrees in any number of digits
     * @return the nearest number of radians
     */
    public static double toRadians(BigDecimal degrees) {
        return degrees.multiply(PI)
                .divide(HALF_TURN, new MathContext(50, RoundingMode.HALF_EVEN))
                .doubleValue();
    }

    /**
     * The shortest decimal text that {@link #toRadians(BigDecimal)} reads back to the same bits.
     *
     * @param radians finite
     * @return degrees, with a point and without exponent
     */
    public static String toText(double radians) {
        BigDecimal exact =
                new BigDecimal(radians).multiply(HALF_TURN).divide(PI, new MathContext(40, RoundingMode.HALF_EVEN));
        for (int digits = 1; digits < MAX_DIGITS; digits++) {
            BigDecimal rounded = exact.round(new MathContext(digits, RoundingMode.HALF_EVEN));
            if (toRadians(rounded) == radians) {
                return rounded.signum() == 0
                        ? "0"
                        : rounded.stripTrailingZeros().toPlainString();
            }
        }
        return exact.stripTrailingZeros().toPlainString();
    }
}
