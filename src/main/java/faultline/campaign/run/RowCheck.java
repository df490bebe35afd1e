package faultline.campaign.run;

import faultline.io.Message;
import faultline.io.MessageText;
import faultline.scenario.xml.ScenarioLimits;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Checks a row of {@code runs.csv}, which people and other programs may have changed. */
public final class RowCheck {

    private static final Pattern RUN = Pattern.compile("\\d{1,18}");

    private static final Set<String> FLAGS = Set.of("", "0", "1");

    private static final String OUTCOMES = Stream.concat(
                    Arrays.stream(Outcome.values()).map(Outcome::word), Stream.of(Outcome.BROKEN))
            .collect(Collectors.joining(", "));

    private RowCheck() {}

    /**
     * {@return the error in a row, as the end of a sentence; empty if the row can be used}
     *
     * @param cell the function that returns the text of a column, empty if there is no such column
     */
    public static Optional<Message> findProblem(UnaryOperator<String> cell) {
        String outcome = cell.apply("outcome");
        if (!RUN.matcher(cell.apply("run")).matches()) {
            return problem("run", cell, ResultsProblem.WHOLE_NUMBER.with());
        }
        boolean broken = outcome.equals(Outcome.BROKEN);
        if (!broken && Outcome.ofWord(outcome).isEmpty()) {
            return problem("outcome", cell, ResultsProblem.ONE_OF.with(OUTCOMES));
        }
        for (String column : List.of("carried_on", "collided")) {
            // A program that stores them as numbers with gaps writes 1.0.
            if (!FLAGS.contains(cell.apply(column))) {
                return problem(column, cell, ResultsProblem.FLAG.with());
            }
        }
        if (number(cell.apply("wall_share")).isEmpty()
                && !cell.apply("wall_share").isEmpty()) {
            return problem("wall_share", cell, ResultsProblem.NUMBER.with());
        }
        if (!isDuration(cell.apply("simulated_s")) && !broken) {
            return problem("simulated_s", cell, ResultsProblem.DURATION.with(ScenarioLimits.MAX_DURATION));
        }
        return Optional.empty();
    }

    /** Returns the error in a row with a header; empty if the row is valid. */
    static Optional<Message> findProblem(List<String> header, List<String> cells) {
        if (cells.size() != header.size()) {
            return Optional.of(cellCount(cells.size(), header.size()));
        }
        return findProblem(column -> header.contains(column) ? cells.get(header.indexOf(column)) : "");
    }

    /** Returns the error in a row of a table of which it must have this run; empty if the row is valid. */
    static Optional<Message> findProblem(List<String> header, List<String> cells, long run) {
        String expected = Long.toString(run);
        return cells.get(0).equals(expected)
                ? findProblem(header, cells)
                : Optional.of(ResultsProblem.CELL.with(header.get(0), MessageText.quoted(cells.get(0)), expected));
    }

    /**
     * {@return the error in a row with another number of cells than the header, as the end of a sentence}
     *
     * @param cells the number of its cells
     * @param expected the number of the header's cells
     */
    public static Message cellCount(int cells, int expected) {
        return cells == 1 ? ResultsProblem.ONE_CELL.with(expected) : ResultsProblem.CELL_COUNT.with(cells, expected);
    }

    /**
     * {@return the number in a cell; empty if it holds no finite one, as some programs write NaN for a missing number}
     *
     * @param text the text of the cell
     */
    public static OptionalDouble number(String text) {
        double number = CellKind.number(text);
        return Double.isFinite(number) ? OptionalDouble.of(number) : OptionalDouble.empty();
    }

    private static boolean isDuration(String text) {
        double seconds = number(text).orElse(-1);
        return seconds >= 0 && seconds <= ScenarioLimits.MAX_DURATION;
    }

    private static Optional<Message> problem(String column, UnaryOperator<String> cell, Message expected) {
        return Optional.of(ResultsProblem.CELL.with(column, MessageText.quoted(cell.apply(column)), expected));
    }
}
