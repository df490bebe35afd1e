package faultline.gui.text;

import faultline.engine.metrics.Expectation;
import faultline.engine.metrics.RunOutcome;
import faultline.io.DecimalText;
import java.util.Locale;

/** Describes what is expected of a run, and what the run has come to. */
public final class ExpectationText implements Expectation.ConditionVisitor<String> {

    private static final ExpectationText INSTANCE = new ExpectationText();

    private ExpectationText() {}

    /** Returns what is expected. */
    public static String format(Expectation.Condition condition) {
        return condition.accept(INSTANCE);
    }

    /** Returns what the run has come to. */
    public static String value(Expectation.Condition condition, RunOutcome outcome) {
        return condition.accept(new OutcomeText(outcome));
    }

    @Override
    public String visit(Expectation.Collides condition) {
        return Messages.get(condition.wanted() ? "expect.collision" : "expect.noCollision");
    }

    @Override
    public String visit(Expectation.MinCoverage condition) {
        return Messages.get("expect.coverage", DecimalText.format(condition.share()));
    }

    @Override
    public String visit(Expectation.MaxDistanceRms condition) {
        return Messages.get("expect.distance", DecimalText.format(condition.metres()));
    }

    @Override
    public String visit(Expectation.VisitedState condition) {
        return Messages.get("expect.state", StateText.name(condition.state()));
    }

    @Override
    public String visit(Expectation.FinalState condition) {
        return Messages.get("expect.finalState", StateText.name(condition.state()));
    }

    /** Returns a number in a format, or a dash for NaN. */
    public static String number(String format, double value) {
        return Double.isNaN(value) ? "–" : String.format(Locale.ROOT, format, value);
    }

    /** Describes what the outcome of a run is in place of what is expected. */
    private record OutcomeText(RunOutcome outcome) implements Expectation.ConditionVisitor<String> {

        @Override
        public String visit(Expectation.Collides condition) {
            return Messages.get(outcome.collision().isEmpty() ? "expect.none" : "expect.collided");
        }

        @Override
        public String visit(Expectation.MinCoverage condition) {
            return number("%.3f", outcome.coverage().orElse(Double.NaN));
        }

        @Override
        public String visit(Expectation.MaxDistanceRms condition) {
            return number("%.4f m", outcome.distanceRms().orElse(Double.NaN));
        }

        @Override
        public String visit(Expectation.VisitedState condition) {
            boolean visited = outcome.visitedStates().contains(condition.state());
            return Messages.get(visited ? "expect.reached" : "expect.notReached");
        }

        @Override
        public String visit(Expectation.FinalState condition) {
            return StateText.name(outcome.finalState());
        }
    }
}
