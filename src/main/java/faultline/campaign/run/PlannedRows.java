package faultline.campaign.run;

import faultline.campaign.plan.CampaignPlan;
import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.ladder.Rung;
import faultline.engine.ControllerFactory;
import faultline.io.Message;
import faultline.io.MessageText;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The rows that the table of a plan can have: each is that of its run, with results that a run can have. */
final class PlannedRows {

    /** The types of controllers whose states and strategies are known. */
    private static final Set<String> KNOWN_TYPES =
            Set.of(ControllerSpec.WallFollowing.TYPE, ControllerSpec.None.TYPE, ControllerSpec.Drive.TYPE);

    private static final int MAX_SHOWN = 200;

    private final CampaignPlan plan;
    private final List<String> names;
    private final Map<String, Integer> indices = new HashMap<>();
    /** The texts that some columns can have. */
    private final Map<String, Set<String>> words;

    PlannedRows(CampaignPlan plan) {
        this.plan = plan;
        this.names = Csv.cells(ResultColumns.header(plan).strip());
        names.forEach(name -> indices.put(name, indices.size()));
        this.words = KNOWN_TYPES.containsAll(plan.controllerTypes()) ? knownWords() : Map.of();
    }

    private static Map<String, Set<String>> knownWords() {
        Set<String> states = Stream.of(
                        ControllerSpec.WallFollowing.DEFAULT, new ControllerSpec.None(), new ControllerSpec.Drive(0, 0))
                .flatMap(spec -> ControllerFactory.states(spec).stream())
                .map(ControllerState::name)
                .collect(Collectors.toSet());
        Set<String> rungs = new HashSet<>(Set.of(""));
        Rung.LADDER.forEach(rung -> rungs.add(rung.name()));
        return Map.of("final_state", states, "final_rung", rungs);
    }

    /** Returns the error in a row that must be that of a run; empty if the program can have written it. */
    Optional<Message> findProblem(List<String> cells, long run) {
        UnaryOperator<String> cell = column -> cells.get(indices.get(column));
        return RowCheck.findProblem(names, cells, run)
                .or(() -> findOtherPlan(cells, run))
                .or(() -> findUnknownWord(cell))
                .or(() -> ResultCheck.findProblem(cell));
    }

    /** Finds a cell that is not what the plan has for the run. */
    private Optional<Message> findOtherPlan(List<String> cells, long run) {
        List<String> planned = ResultColumns.leadingCells(plan.run(run));
        for (int i = 0; i < planned.size(); i++) {
            String given = cells.get(i);
            if (!given.equals(planned.get(i)) && !given.equals(written(planned.get(i)))) {
                return Optional.of(
                        ResultsProblem.CELL.with(names.get(i), quoted(given), expected(written(planned.get(i)))));
            }
        }
        return Optional.empty();
    }

    /** Returns a text as it is read from a table, in which control characters are blanks. */
    private static String written(String text) {
        String row = Csv.row(List.of(text));
        return Csv.cells(row.substring(0, row.length() - 1)).get(0);
    }

    private static Object expected(String text) {
        return text.isEmpty() ? ResultsProblem.NOTHING.with() : quoted(text);
    }

    /** Returns a text in quotes, and more of it than usual, because two sets of sensors can begin alike. */
    private static String quoted(String text) {
        return '"' + MessageText.oneLine(MessageText.shortened(text, MAX_SHOWN)) + '"';
    }

    private Optional<Message> findUnknownWord(UnaryOperator<String> cell) {
        boolean broken = cell.apply("outcome").equals(Outcome.BROKEN);
        return words.entrySet().stream()
                .filter(column -> !broken && !column.getValue().contains(cell.apply(column.getKey())))
                .findFirst()
                .flatMap(column -> ResultCheck.problem(column.getKey(), cell, expected(column.getValue())));
    }

    private static Message expected(Set<String> words) {
        String list = String.join(
                ", ", words.stream().filter(word -> !word.isEmpty()).sorted().toList());
        return words.contains("") ? ResultsProblem.ONE_OF_OR_NOTHING.with(list) : ResultsProblem.ONE_OF.with(list);
    }
}
