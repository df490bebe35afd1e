package faultline.scenario;

import java.math.BigDecimal;

/**
 * The numbers that an attribute may have: the same bounds as in the schema.
 *
 * @param least the lower bound
 * @param leastAllowed whether it is itself allowed
 * @param most the upper bound
 * @param mostAllowed whether it is itself allowed
 * @param unit in words, empty for a number without one
 */
record Range(BigDecimal least, boolean leastAllowed, BigDecimal most, boolean mostAllowed, String unit) {

    static final Range SIZE = closed("0.000001", "100000", "metres");
    static final Range COORDINATE = closed("-100000", "100000", "metres");
    static final Range NOISE = closed("0", "100", "metres");
    static final Range ANGLE = closed("-1000000", "1000000", "degrees");
    static final Range CONE = new Range(BigDecimal.ZERO, false, new BigDecimal("180"), false, "degrees");
    static final Range INCIDENCE = new Range(BigDecimal.ZERO, false, new BigDecimal("90"), true, "degrees");
    static final Range TURN_RATE = closed("0.001", "36000", "degrees per second");
    static final Range SPEED = closed("0", "1000", "metres per second");
    static final Range POSITIVE_SPEED = positive("1000", "metres per second");
    static final Range TIME = closed("0", "10000000", "seconds");
    static final Range TICK = closed("0.00001", "1", "seconds");
    static final Range TIME_CONSTANT = closed("0", "1000", "seconds");
    static final Range VOLTAGE = closed("-10000", "10000", "volts");
    static final Range POSITIVE_VOLTAGE = positive("10000", "volts");
    static final Range SPEED_CONSTANT = positive("1000", "metres per second and volt");
    static final Range SHARE = closed("0", "1", "");

    static Range closed(String least, String most, String unit) {
        return new Range(new BigDecimal(least), true, new BigDecimal(most), true, unit);
    }

    private static Range positive(String most, String unit) {
        return new Range(BigDecimal.ZERO, false, new BigDecimal(most), true, unit);
    }

    boolean contains(BigDecimal value) {
        int below = value.compareTo(least);
        int above = value.compareTo(most);
        return (leastAllowed ? below >= 0 : below > 0) && (mostAllowed ? above <= 0 : above < 0);
    }

    /** What is allowed, in words. */
    @Override
    public String toString() {
        return (leastAllowed ? "from " : "more than ") + least.toPlainString()
                + (mostAllowed ? leastAllowed ? " to " : " and at most " : " and less than ") + most.toPlainString()
                + (unit.isEmpty() ? "" : " " + unit);
    }
}
