package faultline.campaign.report;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.CampaignPlan.FactorSummary;
import faultline.campaign.plan.Column;
import faultline.campaign.plan.FactorKind;
import faultline.campaign.run.CampaignFolder;
import faultline.campaign.run.Csv;
import faultline.campaign.run.LineReader;
import faultline.campaign.run.ResultCheck;
import faultline.campaign.run.ResultColumns;
import faultline.campaign.run.ResultsProblem;
import faultline.campaign.run.RowCheck;
import faultline.io.Message;
import faultline.io.MessageException;
import faultline.io.MessageText;
import faultline.scenario.xml.ScenarioException;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The rows of {@code runs.csv}, and the meaning of their columns according to the plan. */
final class CampaignRuns {

    /** The maximum number of levels of a variable for a comparison of variants. */
    private static final int MAX_COMPARED = 12;

    private static final List<String> NEEDED_COLUMNS =
            List.of("run", "block", "world", "seed", "outcome", "carried_on", "collided");

    private static final String HASH = "trajectory_hash";
    private static final String FOLLOW_ERROR = "follow_rms_m";

    private final CampaignPlan plan;
    private final List<FaultColumns> faults;
    private final Map<String, Integer> indices = new HashMap<>();
    private final List<RunRow> rows = new ArrayList<>();

    /**
     * The header of a table and its rows up to the first one that has more or fewer cells.
     *
     * @param header the names of the columns
     * @param rows the rows with a cell for each column
     * @param damagedCells the number of cells of the row below these; 0 if there is none or it is the last one
     */
    private record ParsedTable(List<String> header, List<List<String>> rows, int damagedCells) {

        /** Reads lines, of which the last one may be incomplete because it is still being written. */
        static ParsedTable of(Iterator<List<String>> lines) {
            List<String> header = lines.hasNext() ? lines.next() : List.of();
            List<List<String>> rows = new ArrayList<>();
            while (lines.hasNext()) {
                List<String> cells = lines.next();
                if (cells.size() != header.size()) {
                    return new ParsedTable(header, rows, lines.hasNext() ? cells.size() : 0);
                }
                rows.add(cells);
            }
            return new ParsedTable(header, rows, 0);
        }
    }

    /** Creates the runs of a table from the cells of its header and rows; an incomplete last row is omitted. */
    CampaignRuns(CampaignPlan plan, Iterable<List<String>> lines) {
        this(plan, ParsedTable.of(lines.iterator()));
    }

    private CampaignRuns(CampaignPlan plan, ParsedTable table) {
        this.plan = plan;
        this.faults = factors(FactorKind.FAULTS).stream().map(FaultColumns::of).toList();
        for (int i = 0; i < table.header().size(); i++) {
            indices.putIfAbsent(table.header().get(i), i);
        }
        Map<List<String>, Integer> firstRuns = new HashMap<>();
        int[] byTrajectory = identityColumns(Stream.of(HASH));
        int[] byResults = identityColumns(ResultColumns.names().filter(name -> !name.equals(HASH)));
        table.rows().forEach(cells -> {
            int[] identity = text(cells, FOLLOW_ERROR).isEmpty() ? byTrajectory : byResults;
            rows.add(new RunRow(this, firstEqual(cells, identity, firstRuns), cells));
        });
    }

    /**
     * Returns the index of the first line of the same run as that of the next row. Runs of a world with the same levels
     * and draws differ in their seeds only. They are the same if all their results are, to the last digit. The
     * trajectory hash is no such result: it covers the noise of sensors that nothing uses. It decides if the error of
     * the distance was not measured, because the other results of different runs are easily equal.
     */
    private int firstEqual(List<String> cells, int[] identity, Map<List<String>, Integer> firstRuns) {
        int next = rows.size();
        if (plan.seedCount() == 1 || text(cells, HASH).isEmpty()) {
            return next;
        }
        List<String> run = Arrays.stream(identity).mapToObj(cells::get).toList();
        return firstRuns.computeIfAbsent(run, first -> next);
    }

    /** Returns a cell of a row, empty if there is no such column. */
    String text(List<String> cells, String column) {
        int index = index(column);
        return index < 0 ? "" : cells.get(index);
    }

    /** Returns the indices of some columns and of those that tell the world, the levels and the draws. */
    private int[] identityColumns(Stream<String> names) {
        return Stream.concat(
                        Stream.concat(Stream.of("world"), names),
                        plan.factorColumns().stream().map(Column::name))
                .mapToInt(this::index)
                .filter(index -> index >= 0)
                .toArray();
    }

    /** Reads the campaign of a folder. Throws an exception if there is none, or a row cannot be used. */
    static CampaignRuns read(Path folder) throws IOException, ScenarioException {
        CampaignFolder campaign = new CampaignFolder(folder);
        campaign.requireReadable();
        if (!Files.isRegularFile(campaign.runs())) {
            throw new MessageException(folder.toString(), ResultsProblem.NO_CAMPAIGN.with(), null);
        }
        return read(campaign.readPlan(), campaign.runs());
    }

    /**
     * Reads a table. Throws an exception if a row cannot be used. The rows are then in the order of the plan, whatever
     * the order of the lines, which a spreadsheet may have sorted.
     */
    static CampaignRuns read(CampaignPlan plan, Path table) throws IOException {
        checkLines(table);
        try (BufferedReader in = Files.newBufferedReader(table)) {
            Map<String, String> shared = new HashMap<>();
            ParsedTable parsed =
                    ParsedTable.of(in.lines().map(line -> cells(line, shared)).iterator());
            if (parsed.damagedCells() > 0) {
                throw wrong(
                        table,
                        parsed.rows().size() + 2,
                        RowCheck.cellCount(
                                parsed.damagedCells(), parsed.header().size()));
            }
            CampaignRuns campaign = new CampaignRuns(plan, parsed);
            campaign.checkColumns(table, parsed.header());
            campaign.checkRows(table);
            campaign.rows.sort(Comparator.comparingLong(row -> Long.parseLong(row.text("run"))));
            return campaign;
        } catch (UncheckedIOException e) {
            throw e.getCause() instanceof CharacterCodingException
                    ? new MessageException(table.toString(), ResultsProblem.NOT_TEXT.with(), e)
                    : e.getCause();
        }
    }

    /**
     * Checks that the columns are there without which every run would be without a result, and that no column of the
     * plan is there twice, because the cells of the two may differ.
     */
    private void checkColumns(Path table, List<String> header) throws IOException {
        List<String> needed = new ArrayList<>(NEEDED_COLUMNS);
        plan.factorColumns().forEach(column -> needed.add(column.name()));
        for (String name : needed) {
            if (!indices.isEmpty() && index(name) < 0) {
                throw new MessageException(
                        table + ":1:1", ResultsProblem.NO_COLUMN.with(MessageText.quoted(name)), null);
            }
        }
        Set<String> known = ResultColumns.of(plan).stream().map(Column::name).collect(Collectors.toSet());
        Set<String> found = new HashSet<>();
        for (String name : header) {
            if (!found.add(name) && known.contains(name)) {
                throw new MessageException(
                        table + ":1:1", ResultsProblem.COLUMN_TWICE.with(MessageText.quoted(name)), null);
            }
        }
    }

    private void checkRows(Path table) throws IOException {
        BitSet runs = new BitSet();
        int line = 1;
        for (RunRow row : rows) {
            line++;
            Optional<Message> problem = RowCheck.findProblem(row::text).or(() -> ResultCheck.findUnusable(row::text));
            if (problem.isPresent()) {
                throw wrong(table, line, problem.get());
            }
            long run = Long.parseLong(row.text("run"));
            if (run >= plan.runCount()) {
                throw wrong(table, line, ResultsProblem.NOT_IN_PLAN.with(run, plan.runCount() - 1));
            }
            if (runs.get((int) run)) {
                throw wrong(table, line, ResultsProblem.TWICE.with(run));
            }
            runs.set((int) run);
        }
        if (rows.isEmpty()) {
            throw new MessageException(table + ":1:1", ResultsProblem.NO_ROW.with(), null);
        }
    }

    private static IOException wrong(Path table, int line, Message problem) {
        return new MessageException(table + ":" + line, problem, null);
    }

    /** Checks the length of the lines, because a long line of a damaged file could fill the memory. */
    private static void checkLines(Path table) throws IOException {
        try (LineReader in = new LineReader(table)) {
            int number = 1;
            for (String line = in.next(); !line.isEmpty(); line = in.next()) {
                if (in.isTooLong()) {
                    throw wrong(table, number, ResultsProblem.LONG_ROW.with());
                }
                number++;
            }
        }
    }

    /** Returns the cells of a row. Equal cells of a table share one string, because most of them occur often. */
    private static List<String> cells(String line, Map<String, String> shared) {
        return Csv.cells(line).stream()
                .map(cell -> shared.computeIfAbsent(cell, same -> same))
                .toList();
    }

    CampaignPlan plan() {
        return plan;
    }

    int worldCount() {
        return plan.worldCount();
    }

    /** Returns the index of a column, -1 if no column has the name. */
    int index(String column) {
        return indices.getOrDefault(column, -1);
    }

    List<RunRow> rows() {
        return rows;
    }

    /** Returns the number of runs that repeat an earlier one. */
    long repeatCount() {
        return rows.size()
                - rows.stream().mapToInt(RunRow::firstEqual).distinct().count();
    }

    /** Returns whether a column has a text in any row. */
    boolean has(String column) {
        return index(column) >= 0
                && rows.stream().anyMatch(row -> !row.text(column).isEmpty());
    }

    /** Returns the factors of a kind. */
    List<FactorSummary> factors(FactorKind kind) {
        return plan.factors().stream().filter(factor -> factor.kind() == kind).toList();
    }

    /** Returns the factors whose levels are compared side by side: attributes and variants with a few levels. */
    List<FactorSummary> comparedFactors() {
        return plan.factors().stream()
                .filter(factor -> factor.kind() == FactorKind.SET || factor.kind() == FactorKind.VARIANTS)
                .filter(factor -> factor.levelCount() > 1 && factor.levelCount() <= MAX_COMPARED)
                .toList();
    }

    /** Returns the columns of numbers that are drawn or have many levels. */
    List<Column> continuousColumns() {
        return plan.factorColumns().stream()
                .filter(column -> rows.stream()
                                .map(row -> row.text(column.name()))
                                .filter(text -> !text.isEmpty())
                                .distinct()
                                .limit(MAX_COMPARED + 1L)
                                .count()
                        > MAX_COMPARED)
                .filter(column ->
                        rows.stream().anyMatch(row -> row.number(column.name()).isPresent()))
                .toList();
    }

    /** Returns the numbers that a column has in some rows. */
    static double[] values(Collection<RunRow> rows, String column) {
        return rows.stream().flatMapToDouble(row -> row.number(column).stream()).toArray();
    }

    /** Groups rows by a key, in the order of their first appearance. */
    static <R, K> Map<K, List<R>> group(Collection<R> rows, Function<R, K> key) {
        Map<K, List<R>> groups = new LinkedHashMap<>();
        rows.forEach(row -> groups.computeIfAbsent(key.apply(row), first -> new ArrayList<>())
                .add(row));
        return groups;
    }

    /** Returns the columns of each element of faults in the plan. */
    List<FaultColumns> faults() {
        return faults;
    }

    /** Returns whether nothing fails in a run. */
    boolean isHealthy(RunRow row) {
        return faults.stream().noneMatch(columns -> columns.isFailing(row));
    }

    /** Returns the names of the faults of a run; empty if the campaign has no faults. */
    String faultName(RunRow row) {
        return joined(row, columns -> columns.failingPart(row) + " " + row.text(columns.fault()));
    }

    /** Returns the kinds of a run's faults, or their labels, whichever sensors have them. */
    String faultKind(RunRow row) {
        return joined(row, columns -> row.text(columns.fault()));
    }

    /** Returns the parts that fail in a run. */
    String failingPart(RunRow row) {
        return joined(row, columns -> columns.failingPart(row));
    }

    /** Joins the names of the faults of a run. */
    private String joined(RunRow row, Function<FaultColumns, String> name) {
        if (faults.isEmpty()) {
            return "";
        }
        String names = faults.stream()
                .filter(columns -> columns.isFailing(row))
                .map(name)
                .collect(Collectors.joining(" + "));
        return names.isEmpty() ? "healthy" : names;
    }
}
