package faultline.gui.panel;

import faultline.engine.metrics.Expectation;
import faultline.engine.metrics.RunOutcome;
import faultline.gui.text.Messages;
import faultline.gui.text.StateText;
import faultline.io.DecimalText;
import java.util.Locale;

/** Describes what is expected of a run, and what the run has come to. */
final class ExpectationText {

    private ExpectationText() {}

    /** Returns what is expected. */
    static String format(Expectation.Condition condition) {
        if (condition instanceof Expectation.Collides collision) {
            return Messages.get(collision.wanted() ? "expect.collision" : "expect.noCollision");
        }
        if (condition instanceof Expectation.MinCoverage coverage) {
            return Messages.get("expect.coverage", DecimalText.format(coverage.share()));
        }
        if (condition instanceof Expectation.MaxDistanceRms rms) {
            return Messages.get("expect.distance", DecimalText.format(rms.metres()));
        }
        return condition instanceof Expectation.VisitedState visited
                ? Messages.get("expect.state", StateText.name(visited.state()))
                : Messages.get("expect.finalState", StateText.name(((Expectation.FinalState) condition).state()));
    }

    /** Returns what the run has come to. */
    static String value(Expectation.Condition condition, RunOutcome outcome) {
        if (condition instanceof Expectation.Collides) {
            return Messages.get(outcome.collision().isEmpty() ? "expect.none" : "expect.collided");
        }
        if (condition instanceof Expectation.MinCoverage) {
            return number("%.3f", outcome.coverage().orElse(Double.NaN));
        }
        if (condition instanceof Expectation.MaxDistanceRms) {
            return number("%.4f m", outcome.distanceRms().orElse(Double.NaN));
        }
        if (condition instanceof Expectation.VisitedState visited) {
            return Messages.get(
                    outcome.visitedStates().contains(visited.state()) ? "expect.reached" : "expect.notReached");
        }
        return StateText.name(outcome.finalState());
    }

    static String number(String format, double value) {
        return Double.isNaN(value) ? "–" : String.format(Locale.ROOT, format, value);
    }
}
