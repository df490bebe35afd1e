package faultline.gui.text;

import faultline.engine.metrics.Expectation;
import faultline.engine.metrics.Expectation.ConditionCases;
import faultline.engine.metrics.RunOutcome;
import faultline.io.DecimalText;
import java.util.Locale;

/** Describes what is expected of a run, and its result so far. */
public final class ExpectationText {

    private ExpectationText() {}

    /** Returns what is expected. */
    public static String format(Expectation.Condition condition) {
        return condition.match(new ConditionCases<>(
                collides -> Messages.get(collides.wanted() ? "expect.collision" : "expect.noCollision"),
                coverage -> Messages.get("expect.coverage", DecimalText.format(coverage.share())),
                distance -> Messages.get("expect.distance", DecimalText.format(distance.metres())),
                visited -> Messages.get("expect.state", StateText.name(visited.state())),
                last -> Messages.get("expect.finalState", StateText.name(last.state()))));
    }

    /** Returns the result of the run so far. */
    public static String value(Expectation.Condition condition, RunOutcome outcome) {
        return condition.match(new ConditionCases<>(
                collides -> Messages.get(outcome.collision().isEmpty() ? "expect.none" : "expect.collided"),
                coverage -> number("%.3f", outcome.coverage().orElse(Double.NaN)),
                distance -> number("%.4f m", outcome.distanceRms().orElse(Double.NaN)),
                visited -> Messages.get(
                        outcome.visitedStates().contains(visited.state()) ? "expect.reached" : "expect.notReached"),
                last -> StateText.name(outcome.finalState())));
    }

    /** Returns a number in a format, or a dash for NaN. */
    public static String number(String format, double value) {
        return Double.isNaN(value) ? "–" : String.format(Locale.ROOT, format, value);
    }
}
