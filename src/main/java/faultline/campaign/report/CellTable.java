package faultline.campaign.report;

import faultline.campaign.plan.CampaignPlan.FactorSummary;
import faultline.campaign.plan.FactorKind;
import faultline.campaign.run.Csv;
import faultline.campaign.run.Outcome;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.regex.Pattern;

/**
 * The cells of a campaign as CSV: one row for each combination of levels, and additional rows for all faults, all
 * sensors and each rung of the ladder.
 */
final class CellTable {

    /** The label of a cell that is a sum over all faults, sensors or rungs. */
    static final String ALL = "all";

    private static final Pattern QUOTED_TOTAL = Pattern.compile("\"*" + ALL + "\"*");

    private final CampaignRuns campaign;
    private final List<FactorSummary> levels;
    private final List<FaultColumns> faults;

    CellTable(CampaignRuns campaign) {
        this.campaign = campaign;
        this.levels = campaign.plan().factors().stream()
                .filter(factor -> factor.kind() != FactorKind.FAULTS && factor.levelCount() > 1)
                .toList();
        this.faults = campaign.faults();
    }

    String csv() {
        StringBuilder out = new StringBuilder(Csv.row(header()));
        groups().forEach((key, rows) -> {
            List<String> cells = new ArrayList<>(key);
            cells.addAll(numbers(rows));
            out.append(Csv.row(cells));
        });
        return out.toString();
    }

    private List<String> header() {
        List<String> header = new ArrayList<>(labelColumns());
        header.addAll(List.of("final_rung", "runs", "carried_on", "share", "share_low", "share_high"));
        Arrays.stream(Outcome.values())
                .filter(outcome -> outcome != Outcome.CARRIED_ON)
                .forEach(outcome -> header.add(outcome.word()));
        header.addAll(List.of(
                Outcome.BROKEN,
                "detected",
                "delay_median_s",
                "delay_90_s",
                "false_alarm_runs",
                "view_median_s",
                "error_median_m"));
        return header;
    }

    /** Returns the columns whose values define a cell, except the rung. */
    List<String> labelColumns() {
        List<String> header = new ArrayList<>();
        levels.forEach(factor -> header.add(factor.columns().get(0).name()));
        faults.forEach(columns -> {
            header.add(columns.fault());
            header.add(columns.sensor());
        });
        return header;
    }

    /** Returns the runs of every cell by its labels, the rung last. */
    Map<List<String>, List<RunRow>> groups() {
        Map<List<String>, List<RunRow>> groups = new LinkedHashMap<>();
        for (RunRow row : campaign.rows()) {
            List<String> level = levels.stream()
                    .map(factor -> row.text(factor.columns().get(0).name()))
                    .toList();
            for (List<String> fault : faultKeys(row)) {
                add(groups, level, fault, ALL, row);
            }
            if (!row.text("final_rung").isEmpty()) {
                add(groups, level, pooled(row), quotedIfTotal(row.text("final_rung")), row);
            }
        }
        return groups;
    }

    /**
     * Returns whether the labels of a cell are those of a sum over faults or sensors. Other levels are never summed.
     */
    boolean isSum(List<String> labels) {
        return labels.subList(levels.size(), labels.size()).contains(ALL);
    }

    /**
     * Returns a name of the user as a label. If it is the word for totals, with or without quotes, it is put in quotes,
     * so that different cells have different labels.
     */
    private static String quotedIfTotal(String name) {
        return QUOTED_TOTAL.matcher(name).matches() ? '"' + name + '"' : name;
    }

    private static void add(
            Map<List<String>, List<RunRow>> groups, List<String> level, List<String> fault, String rung, RunRow row) {
        List<String> key = new ArrayList<>(level);
        key.addAll(fault);
        key.add(rung);
        groups.computeIfAbsent(key, first -> new ArrayList<>()).add(row);
    }

    /**
     * Returns the cells of a run. With one fault, these are its own cell and the cells of its fault, its sensor, and
     * all faults. With two faults, they are the cell of their kinds and that of all faults.
     */
    private List<List<String>> faultKeys(RunRow row) {
        List<String> own = new ArrayList<>();
        faults.forEach(columns -> {
            own.add(quotedIfTotal(row.text(columns.fault())));
            own.add(quotedIfTotal(columns.failingPart(row)));
        });
        if (faults.isEmpty() || pooled(row).equals(own)) {
            return List.of(own);
        }
        if (faults.size() > 1) {
            return List.of(kinds(row), pooled(row));
        }
        return List.of(own, List.of(own.get(0), ALL), List.of(ALL, own.get(1)), List.of(ALL, ALL));
    }

    /** Returns the cell of the kinds of a run's faults, whichever sensors have them. */
    private List<String> kinds(RunRow row) {
        List<String> keys = new ArrayList<>();
        faults.forEach(columns -> {
            keys.add(quotedIfTotal(row.text(columns.fault())));
            keys.add(columns.isFailing(row) ? ALL : "");
        });
        return keys;
    }

    /** Returns the cell of all faults for a run with any, that of healthy runs for others. */
    private List<String> pooled(RunRow row) {
        List<String> keys = new ArrayList<>();
        faults.forEach(columns -> {
            keys.add(columns.isFailing(row) ? ALL : row.text(columns.fault()));
            keys.add(columns.isFailing(row) ? ALL : "");
        });
        return keys;
    }

    private static List<String> numbers(List<RunRow> rows) {
        Survival survival = Survival.of(rows);
        List<String> cells = new ArrayList<>(List.of(
                Integer.toString(rows.size()),
                Integer.toString(survival.successes()),
                fixed(survival.share()),
                fixed(survival.interval().low()),
                fixed(survival.interval().high())));
        for (Outcome outcome : Outcome.values()) {
            if (outcome != Outcome.CARRIED_ON) {
                cells.add(count(rows, outcome.word()));
            }
        }
        cells.add(count(rows, Outcome.BROKEN));
        cells.add(Integer.toString(CampaignRuns.values(rows, FaultSections.DELAY).length));
        cells.add(quantile(rows, FaultSections.DELAY, 0.5));
        cells.add(quantile(rows, FaultSections.DELAY, 0.9));
        cells.add(Long.toString(rows.stream()
                .filter(row -> row.number("false_alarms").orElse(0) > 0)
                .count()));
        cells.add(quantile(rows, "detection_view_s", 0.5));
        cells.add(quantile(rows, "detection_error_m", 0.5));
        return cells;
    }

    private static String quantile(List<RunRow> rows, String column, double share) {
        OptionalDouble value = LowerQuantile.of(CampaignRuns.values(rows, column), share);
        return value.isPresent() ? fixed(value.getAsDouble()) : "";
    }

    private static String count(List<RunRow> rows, String outcome) {
        return Long.toString(
                rows.stream().filter(row -> row.text("outcome").equals(outcome)).count());
    }

    private static String fixed(double value) {
        return String.format(Locale.ROOT, "%.4f", value);
    }
}
