package faultline.campaign.run;

import faultline.engine.metrics.CarryOnMetrics;
import faultline.io.Message;
import faultline.io.MessageText;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;

/** Checks the results in a row of {@code runs.csv} that {@link RowCheck} has found no error in. */
public final class ResultCheck {

    /** Times are rounded to this, seconds, so that one can be a little greater than the duration of its run. */
    private static final double ROUNDING = 1e-3;

    private ResultCheck() {}

    /**
     * {@return the error in a row that another program may have written, as the end of a sentence; empty if its numbers
     * can be used}
     *
     * @param cell the function that returns the text of a column, empty if there is no such column
     */
    public static Optional<Message> findUnusable(UnaryOperator<String> cell) {
        for (Map.Entry<String, CellKind> column : ResultColumns.KINDS.entrySet()) {
            if (!column.getValue().isUsable(cell.apply(column.getKey()))) {
                return problem(column.getKey(), cell, column.getValue().expected());
            }
        }
        return Optional.empty();
    }

    /** Returns the first result that no run of this program has; empty if there is none. */
    static Optional<Message> findProblem(UnaryOperator<String> cell) {
        String outcome = cell.apply("outcome");
        if (outcome.equals(Outcome.BROKEN)) {
            return ResultColumns.KINDS.keySet().stream()
                    .filter(column -> !List.of("outcome", "failure").contains(column))
                    .flatMap(column -> findOther(column, cell, "", outcome).stream())
                    .findFirst();
        }
        for (Map.Entry<String, CellKind> column : ResultColumns.KINDS.entrySet()) {
            if (!column.getValue().contains(cell.apply(column.getKey()))) {
                return problem(column.getKey(), cell, column.getValue().expected());
            }
        }
        return findOtherOutcome(cell, Outcome.ofWord(outcome).orElseThrow())
                .or(() -> findOtherPresence(cell))
                .or(() -> findLaterTime(cell));
    }

    /** Finds a result that a run with this outcome does not have. */
    private static Optional<Message> findOtherOutcome(UnaryOperator<String> cell, Outcome outcome) {
        boolean collided = outcome == Outcome.COLLIDED;
        String word = outcome.word();
        return findOther("carried_on", cell, outcome.flag(), word)
                .or(() -> findOther("collided", cell, collided ? "1" : "0", word))
                .or(() -> findOtherPresence("collision_time_s", cell, collided, word))
                .or(() -> findOtherPresence("collided_with", cell, collided, word))
                .or(() -> findLowShare(cell, outcome))
                .or(() -> findOtherPresence("trajectory_hash", cell, true, word))
                .or(() -> findOther("failure", cell, "", word));
    }

    private static Optional<Message> findOther(
            String column, UnaryOperator<String> cell, String expected, String outcome) {
        return cell.apply(column).equals(expected)
                ? Optional.empty()
                : problem(column, cell, ResultsProblem.WITH_OUTCOME.with(textOrNothing(expected), outcome));
    }

    private static Optional<Message> findOtherPresence(
            String column, UnaryOperator<String> cell, boolean present, String outcome) {
        return cell.apply(column).isEmpty() != present
                ? Optional.empty()
                : problem(column, cell, ResultsProblem.WITH_OUTCOME.with(valueOrNothing(present), outcome));
    }

    private static Optional<Message> findLowShare(UnaryOperator<String> cell, Outcome outcome) {
        String share = cell.apply("wall_share");
        boolean low = share.isEmpty() || CellKind.number(share) < CarryOnMetrics.REQUIRED_SHARE;
        return outcome != Outcome.CARRIED_ON || !low
                ? Optional.empty()
                : problem(
                        "wall_share",
                        cell,
                        ResultsProblem.WITH_OUTCOME.with(
                                ResultsProblem.AT_LEAST.with(CarryOnMetrics.REQUIRED_SHARE), outcome.word()));
    }

    /** Finds a result that is there without another one that it is measured with, or the other way round. */
    private static Optional<Message> findOtherPresence(UnaryOperator<String> cell) {
        return findOtherPresence("laps", cell, "wall_share")
                .or(() -> isMissing(cell, "wall_share")
                        ? Optional.empty()
                        : findOtherPresence("clock_start_s", cell, "wall_share"))
                .or(() -> findOtherPresence("detection_view_s", cell, "detection_delay_s"))
                .or(() -> findOtherPresence("detection_error_m", cell, "detection_delay_s"))
                .or(() -> isMissing(cell, "detection_delay_s")
                        ? Optional.empty()
                        : findOtherPresence("false_alarms", cell, "detection_delay_s"));
    }

    private static boolean isMissing(UnaryOperator<String> cell, String column) {
        return cell.apply(column).isEmpty();
    }

    private static Optional<Message> findOtherPresence(String column, UnaryOperator<String> cell, String other) {
        return isMissing(cell, column) == isMissing(cell, other)
                ? Optional.empty()
                : problem(column, cell, ResultsProblem.AS_IN.with(valueOrNothing(!isMissing(cell, other)), other));
    }

    /** Finds a time that is after the end of the run. */
    private static Optional<Message> findLaterTime(UnaryOperator<String> cell) {
        String duration = cell.apply("simulated_s");
        double latest = CellKind.number(duration) + ROUNDING;
        for (String column : List.of("collision_time_s", "clock_start_s", "detection_delay_s")) {
            if (CellKind.number(cell.apply(column)) > latest) {
                return problem(column, cell, ResultsProblem.AT_MOST_OF.with(duration, "simulated_s"));
            }
        }
        return Optional.empty();
    }

    private static Object valueOrNothing(boolean present) {
        return present ? ResultsProblem.VALUE.with() : ResultsProblem.NOTHING.with();
    }

    private static Object textOrNothing(String text) {
        return text.isEmpty() ? ResultsProblem.NOTHING.with() : MessageText.quoted(text);
    }

    /** Returns the error that a cell is not what is expected. */
    static Optional<Message> problem(String column, UnaryOperator<String> cell, Object expected) {
        return Optional.of(ResultsProblem.CELL.with(column, MessageText.quoted(cell.apply(column)), expected));
    }
}
