package faultline.scenario.xml;

import java.math.BigDecimal;

/**
 * The numbers that an attribute may have: the same bounds as in the schema.
 *
 * @param min the lower bound
 * @param minInclusive whether it is itself allowed
 * @param max the upper bound
 * @param maxInclusive whether it is itself allowed
 * @param unit in words, empty for a number without one
 */
record NumberRange(BigDecimal min, boolean minInclusive, BigDecimal max, boolean maxInclusive, String unit) {

    static final NumberRange SIZE = closed("0.000001", "100000", "metres");
    static final NumberRange COORDINATE = closed("-100000", "100000", "metres");
    static final NumberRange NOISE = closed("0", "100", "metres");
    static final NumberRange ANGLE = closed("-1000000", "1000000", "degrees");
    static final NumberRange CONE = new NumberRange(BigDecimal.ZERO, false, new BigDecimal("180"), false, "degrees");
    static final NumberRange INCIDENCE_ANGLE =
            new NumberRange(BigDecimal.ZERO, false, new BigDecimal("90"), true, "degrees");
    static final NumberRange TURN_RATE = closed("0.001", "36000", "degrees per second");
    static final NumberRange SPEED = closed("0", "1000", "metres per second");
    static final NumberRange POSITIVE_SPEED = positive("1000", "metres per second");
    static final NumberRange TIME = closed("0", "10000000", "seconds");
    static final NumberRange TICK = closed("0.00001", "1", "seconds");
    static final NumberRange TIME_CONSTANT = closed("0", "1000", "seconds");
    static final NumberRange VOLTAGE = closed("-10000", "10000", "volts");
    static final NumberRange POSITIVE_VOLTAGE = positive("10000", "volts");
    static final NumberRange SPEED_CONSTANT = positive("1000", "metres per second and volt");
    static final NumberRange FRACTION = closed("0", "1", "");

    static NumberRange closed(String least, String most, String unit) {
        return new NumberRange(new BigDecimal(least), true, new BigDecimal(most), true, unit);
    }

    private static NumberRange positive(String most, String unit) {
        return new NumberRange(BigDecimal.ZERO, false, new BigDecimal(most), true, unit);
    }

    boolean contains(BigDecimal value) {
        int below = value.compareTo(min);
        int above = value.compareTo(max);
        return (minInclusive ? below >= 0 : below > 0) && (maxInclusive ? above <= 0 : above < 0);
    }

    /** What is allowed, in words. */
    @Override
    public String toString() {
        return (minInclusive ? "from " : "more than ")
                + min.toPlainString()
                + (maxInclusive ? minInclusive ? " to " : " and at most " : " and less than ")
                + max.toPlainString()
                + (unit.isEmpty() ? "" : " " + unit);
    }
}
