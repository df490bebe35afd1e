package faultline.gui.batch;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.Column;
import faultline.campaign.report.CampaignCell;
import faultline.campaign.report.Survival;
import faultline.campaign.run.ResultColumns;
import faultline.io.DecimalText;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;

/** The results of a batch as far as they have come, in the forms that its views show. Event dispatch thread only. */
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
    private final List<String> columns;
    private final List<List<String>> rows = new ArrayList<>();
    private final List<String> shownColumns;
    private final List<String> labelColumns;
    /** The numbers of the columns that have been requested, NaN for none. */
    private final Map<String, List<Double>> numbers = new HashMap<>();

    BatchResults(CampaignPlan plan) {
        this.plan = plan;
        labelColumns = CampaignCell.labelColumns(plan);
        columns = ResultColumns.of(plan).stream().map(Column::name).toList();
        shownColumns = Stream.of(
                        Stream.of("run", "seed"),
                        plan.factorColumns().stream().map(Column::name).filter(name -> !name.endsWith("end_s")),
                        RUN_COLUMNS.stream())
                .flatMap(names -> names)
                .toList();
    }

    CampaignPlan plan() {
        return plan;
    }

    /** Adds a row of {@code runs.csv}. */
    void add(List<String> cells) {
        rows.add(cells);
    }

    int size() {
        return rows.size();
    }

    /** Returns a value of a run, as in {@code runs.csv}. */
    String value(int run, String column) {
        return rows.get(run).get(columns.indexOf(column));
    }

    /** Returns the columns of the table of runs. */
    List<String> runColumns() {
        return shownColumns;
    }

    /** Returns a row of the table of runs. */
    List<ResultCell> runRow(int run) {
        return shownColumns.stream()
                .map(column -> ResultCell.of(column, value(run, column)))
                .toList();
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
    double[] numbers(String column, List<Long> runs) {
        List<Double> known = numbers.computeIfAbsent(column, first -> new ArrayList<>());
        while (known.size() < size()) {
            known.add(DecimalText.parse(value(known.size(), column))
                    .map(BigDecimal::doubleValue)
                    .orElse(Double.NaN));
        }
        return runs.stream()
                .filter(run -> run < size())
                .mapToDouble(run -> known.get(run.intValue()))
                .filter(number -> !Double.isNaN(number))
                .toArray();
    }
}
