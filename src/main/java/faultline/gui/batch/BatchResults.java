package faultline.gui.batch;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.Column;
import faultline.campaign.report.CampaignCell;
import faultline.campaign.report.Survival;
import faultline.campaign.run.ResultColumns;
import faultline.io.DecimalText;
import java.math.BigDecimal;
import java.util.AbstractList;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * The results of a batch as far as they have come, in the forms that its views show. Event dispatch thread only, once
 * it is shown.
 */
final class BatchResults {

    private static final List<String> CELL_COLUMNS =
            List.of("runs", "without_contact", "carried_on", "coverage", "distance_rms_m");
    private static final List<String> RUN_COLUMNS = List.of(
            "outcome",
            "collision_time_s",
            "coverage",
            "distance_rms_m",
            "detection_delay_s",
            "trajectory_hash",
            "failure");

    private final CampaignPlan plan;
    private final Map<String, Integer> columns = new HashMap<>();
    private final List<List<String>> rows = new ArrayList<>();
    /** The rows by the numbers of their runs. */
    private final Map<Long, Integer> rowsByRun = new LinkedHashMap<>();

    private final List<String> shownColumns;
    private final List<String> labelColumns;
    /** The numbers of the columns that have been requested by row, NaN for none. */
    private final Map<String, List<Double>> numbers = new HashMap<>();

    BatchResults(CampaignPlan plan) {
        this.plan = plan;
        labelColumns = CampaignCell.labelColumns(plan);
        ResultColumns.of(plan).forEach(column -> columns.put(column.name(), columns.size()));
        shownColumns = Stream.of(
                        plan.worldCount() > 1 ? Stream.of("run", "world", "seed") : Stream.of("run", "seed"),
                        plan.factors().stream()
                                .flatMap(factor -> factor.columns().stream().map(Column::name)),
                        RUN_COLUMNS.stream())
                .flatMap(names -> names)
                .toList();
    }

    CampaignPlan plan() {
        return plan;
    }

    /** Adds a row of {@code runs.csv}. */
    void add(List<String> cells) {
        rowsByRun.put(Long.parseLong(cells.get(0)), rows.size());
        rows.add(cells);
    }

    /** Removes all rows but the first ones. */
    void keepRows(int count) {
        rows.subList(count, rows.size()).clear();
        rowsByRun.values().removeIf(row -> row >= count);
        numbers.clear();
    }

    /** Returns the number of the run of a row. The runs of a part of a campaign do not begin at 0. */
    long run(int row) {
        return Long.parseLong(rows.get(row).get(0));
    }

    /** Returns the first row of some runs; empty if none of them has a row. */
    OptionalInt firstRow(Collection<Long> runs) {
        return runs.stream()
                .filter(rowsByRun::containsKey)
                .mapToInt(rowsByRun::get)
                .min();
    }

    /** Returns the numbers of all runs. */
    Collection<Long> runs() {
        return Collections.unmodifiableSet(rowsByRun.keySet());
    }

    int size() {
        return rows.size();
    }

    /** Returns a value of a row, as in {@code runs.csv}. */
    String value(int row, String column) {
        return rows.get(row).get(columns.get(column));
    }

    /** Returns the columns of the table of runs. */
    List<String> runColumns() {
        return shownColumns;
    }

    /** Returns a row of the table of runs. */
    List<ResultCell> runRow(int row) {
        return new ShownRow(rows.get(row));
    }

    /** A row of the table of runs, which makes its cells when they are asked for, because there may be very many. */
    private final class ShownRow extends AbstractList<ResultCell> {
        private final List<String> values;

        ShownRow(List<String> values) {
            this.values = values;
        }

        @Override
        public ResultCell get(int index) {
            String column = shownColumns.get(index);
            return ResultCell.of(column, values.get(columns.get(column)));
        }

        @Override
        public int size() {
            return shownColumns.size();
        }
    }

    /**
     * Returns the cells of a table in the order in which they are shown, given the texts of its header and rows. The
     * sums come last, and only when the first block of runs is complete, so that no cell changes its place while runs
     * are added. A sum over the same runs as another cell is omitted. Safe on any thread.
     */
    static List<CampaignCell> cellsOf(CampaignPlan plan, List<List<String>> lines) {
        List<CampaignCell> all = CampaignCell.allOf(plan, lines);
        List<CampaignCell> ordered = new ArrayList<>(
                all.stream().filter(Predicate.not(CampaignCell::sum)).toList());
        if (lines.size() > plan.cellCount()) {
            Set<List<Long>> known = new HashSet<>();
            ordered.forEach(cell -> known.add(cell.runs()));
            all.stream()
                    .filter(CampaignCell::sum)
                    .filter(cell -> known.add(cell.runs()))
                    .forEach(ordered::add);
        }
        return ordered;
    }

    /** Returns the columns of the table of cells. */
    List<String> cellColumns() {
        return Stream.concat(labelColumns.stream(), CELL_COLUMNS.stream()).toList();
    }

    /** Returns a row of the table of cells. */
    List<ResultCell> cellRow(CampaignCell cell) {
        List<ResultCell> row = new ArrayList<>();
        for (int i = 0; i < cell.labels().size(); i++) {
            row.add(ResultCell.ofText(
                    ResultCell.word(labelColumns.get(i), cell.labels().get(i))));
        }
        row.add(ResultCell.ofNumber(cell.runs().size(), 0));
        row.add(shareCell(cell.withoutContact()));
        row.add(shareCell(cell.carriedOn()));
        row.add(ResultCell.ofNumber(cell.coverageOrNaN(), 3));
        row.add(ResultCell.ofMillimetres(cell.distanceRmsOrNaN()));
        return row;
    }

    /** Returns a share with its interval, in percent; empty without runs. */
    private static ResultCell shareCell(Survival share) {
        if (share.n() == 0) {
            return ResultCell.ofNumber(Double.NaN, 0);
        }
        String text = String.format(
                Locale.ROOT,
                "%s %% [%s, %s] / %d",
                Survival.percentText(share.share()),
                Survival.percentText(share.interval().low()),
                Survival.percentText(share.interval().high()),
                share.n());
        return new ResultCell(text, share.share());
    }

    /** Returns the numbers of a column, of those runs that have one. */
    double[] numbers(String column, Collection<Long> runs) {
        List<Double> known = numbers.computeIfAbsent(column, first -> new ArrayList<>());
        while (known.size() < size()) {
            known.add(DecimalText.parse(value(known.size(), column))
                    .map(BigDecimal::doubleValue)
                    .orElse(Double.NaN));
        }
        return runs.stream()
                .filter(rowsByRun::containsKey)
                .mapToDouble(run -> known.get(rowsByRun.get(run)))
                .filter(number -> !Double.isNaN(number))
                .toArray();
    }
}
