package faultline.campaign.run;

import faultline.engine.metrics.CarryOnMetrics;
import faultline.engine.metrics.RunResult;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** The outcomes of a run, from the worst to the best. */
public enum Outcome {
    /** The robot touched something. */
    COLLIDED,
    /** The robot did not pass enough of its wall in time, and was not at rest at the end. */
    LOST,
    /** The robot did not pass enough of its wall in time, and was at rest at the end. */
    STOPPED,
    /** The run ended before the time limit. */
    UNDECIDED,
    /** The robot touched nothing and passed enough of its wall in time. */
    CARRIED_ON;

    /** The word in {@code runs.csv} for a run that failed, which has no outcome. */
    public static final String BROKEN = "broken";

    /** The speed below which wheels are at rest, metres per second. */
    private static final double REST_SPEED = 1e-3;

    static Outcome of(RunResult result, CarryOnMetrics metrics) {
        if (result.collision().isPresent()) {
            return COLLIDED;
        }
        if (metrics.carriedOn()) {
            return CARRIED_ON;
        }
        boolean atRest = Math.abs(result.finalSnapshot().wheelSpeeds().left()) < REST_SPEED
                && Math.abs(result.finalSnapshot().wheelSpeeds().right()) < REST_SPEED;
        if (atRest && metrics.isDecided()) {
            return STOPPED;
        }
        return metrics.isDecided() ? LOST : UNDECIDED;
    }

    /** Returns the text in the column {@code carried_on}: 1, 0, or nothing without a verdict. */
    String flag() {
        return this == UNDECIDED ? "" : this == CARRIED_ON ? "1" : "0";
    }

    /** {@return the word in {@code runs.csv}} */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /**
     * {@return the outcome of a word in {@code runs.csv}; empty for {@link #BROKEN} and for any other text}
     *
     * @param word the text of a cell
     */
    public static Optional<Outcome> ofWord(String word) {
        return Arrays.stream(values())
                .filter(outcome -> outcome.word().equals(word))
                .findFirst();
    }
}
