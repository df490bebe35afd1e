package faultline.scenario;

import faultline.control.RecordedDecision;
import faultline.io.DecimalText;
import java.math.BigDecimal;
import java.util.Optional;

/**
 * The text {@code left,right*ticks}: two voltages and the number of ticks for which they hold; without a number, it is
 * one.
 *
 * @param left volts
 * @param right volts
 * @param ticks the number of ticks, at least one
 */
record DecisionText(double left, double right, long ticks) {

    /** The maximum number of ticks of a decision, and of a whole record. No run is as long. */
    static final long MAX_TICKS = 1L << 53;

    static String format(RecordedDecision decision, long end) {
        String pair = DecimalText.format(decision.leftVolts()) + "," + DecimalText.format(decision.rightVolts());
        long ticks = end - decision.tick();
        return ticks == 1 ? pair : pair + "*" + ticks;
    }

    static Optional<DecisionText> parse(String text) {
        int comma = text.indexOf(',');
        int star = text.indexOf('*');
        if (comma < 0 || star >= 0 && star < comma) {
            return Optional.empty();
        }
        Optional<Double> left = parseVolts(text.substring(0, comma));
        Optional<Double> right = parseVolts(text.substring(comma + 1, star < 0 ? text.length() : star));
        Optional<Long> ticks = star < 0 ? Optional.of(1L) : parseTicks(text.substring(star + 1));
        return left.isPresent() && right.isPresent() && ticks.isPresent()
                ? Optional.of(new DecisionText(left.get(), right.get(), ticks.get()))
                : Optional.empty();
    }

    private static Optional<Double> parseVolts(String text) {
        Optional<BigDecimal> exact = DecimalText.parse(text);
        return exact.map(number -> DecimalText.toDouble(number, text)).filter(Double::isFinite);
    }

    private static Optional<Long> parseTicks(String text) {
        return DecimalText.parse(text)
                .filter(number -> number.signum() > 0 && number.compareTo(BigDecimal.valueOf(MAX_TICKS)) <= 0)
                .filter(number -> number.stripTrailingZeros().scale() <= 0)
                .map(BigDecimal::longValue);
    }
}
