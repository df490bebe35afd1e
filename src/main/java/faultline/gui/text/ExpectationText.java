package faultline.gui.text;

import faultline.engine.metrics.Expectation;
import faultline.engine.metrics.Expectation.ConditionCases;
import faultline.engine.metrics.RunFacts;
import faultline.io.DecimalText;
import java.math.BigDecimal;

/** Describes what is expected of a run, and its result so far, in percent and millimetres. */
public final class ExpectationText {

    private static final int PERCENT_DIGITS = 2;
    private static final int MILLIMETRE_DIGITS = 3;

    private ExpectationText() {}

    /** Returns what is expected. */
    public static String format(Expectation.Condition condition) {
        return condition.match(new ConditionCases<>(
                collides -> Messages.get(collides.wanted() ? "expect.collision" : "expect.noCollision"),
                coverage -> Messages.get("expect.coverage", scaled(coverage.share(), PERCENT_DIGITS)),
                distance -> Messages.get("expect.distance", scaled(distance.metres(), MILLIMETRE_DIGITS)),
                visited -> Messages.get("expect.state", StateText.name(visited.state())),
                last -> Messages.get("expect.finalState", StateText.name(last.state()))));
    }

    /** Returns the result of the run so far. */
    public static String value(Expectation.Condition condition, RunFacts facts) {
        return condition.match(new ConditionCases<>(
                collides -> Messages.get(facts.collision().isEmpty() ? "expect.none" : "expect.collided"),
                coverage -> percent(facts.coverage().orElse(Double.NaN)),
                distance -> millimetres(facts.distanceRms().orElse(Double.NaN)),
                visited -> Messages.get(
                        facts.visitedStates().contains(visited.state()) ? "expect.reached" : "expect.notReached"),
                last -> StateText.name(facts.finalState())));
    }

    /** Returns a value times a power of ten, without the error of a multiplication of doubles. */
    private static String scaled(double value, int digits) {
        return new BigDecimal(DecimalText.format(value))
                .movePointRight(digits)
                .stripTrailingZeros()
                .toPlainString();
    }

    /** Returns a share in percent, or a dash for NaN. */
    public static String percent(double share) {
        return NumberText.formatOrDash("%.1f %%", Math.pow(10, PERCENT_DIGITS) * share);
    }

    /** Returns a distance in metres in millimetres, or a dash for NaN. */
    public static String millimetres(double metres) {
        return NumberText.formatOrDash("%.1f mm", Math.pow(10, MILLIMETRE_DIGITS) * metres);
    }
}
