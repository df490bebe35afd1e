package faultline.campaign.report;

import faultline.campaign.plan.CampaignPlan.FactorSummary;
import faultline.campaign.plan.Column;
import faultline.campaign.plan.FactorKind;
import faultline.io.DecimalText;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The sections on factors: levels side by side, and shares over drawn numbers. */
final class VariantSections {

    /** The numbers that are compared in addition to the share of runs carried on, by their columns. */
    private static final List<String> METRICS =
            List.of("coverage", "distance_rms_m", "follow_rms_m", "wall_share", "laps", "detection_delay_s");

    private static final int BINS = 10;

    private final RunData data;

    VariantSections(RunData data) {
        this.data = data;
    }

    /** Returns a section for each compared factor. */
    String comparisons() {
        StringBuilder out = new StringBuilder();
        for (FactorSummary factor : data.comparedFactors()) {
            Comparison comparison = new Comparison(data, factor);
            List<String> levels = List.copyOf(comparison.levels(data.rows()).keySet());
            if (levels.size() > 1) {
                out.append(Html.section(
                        comparison.column() + ": " + String.join(", ", levels), comparison(comparison, levels)));
            }
        }
        return out.toString();
    }

    private String comparison(Comparison comparison, List<String> levels) {
        return Html.paragraph("Share of runs carried on at each level, and the difference to " + levels.get(0)
                        + " on the same worlds, seeds and draws, in percentage points with its 95 % interval (paired,"
                        + " Newcombe). A difference whose interval does not contain 0 is in bold. Intervals are not"
                        + " corrected for their number: where nothing differs, one in twenty is in bold by chance.")
                + survivalTable(comparison, levels)
                + forests(comparison, levels)
                + Html.paragraph("Means of other numbers, and their paired differences to " + levels.get(0)
                        + " with 95 % intervals (Student's t over worlds).")
                + metricTable(comparison, levels);
    }

    private String survivalTable(Comparison comparison, List<String> levels) {
        List<String> header = new ArrayList<>(List.of("runs"));
        for (int i = 0; i < levels.size(); i++) {
            header.add(Html.escape(levels.get(i)));
            if (i > 0) {
                header.add("difference");
            }
        }
        List<List<String>> rows = new ArrayList<>();
        comparison.faultGroups().forEach((name, group) -> {
            rows.add(survivalRow(comparison, levels, name, group));
        });
        return Html.table("matrix", header, rows);
    }

    private List<String> survivalRow(Comparison comparison, List<String> levels, String name, List<RunRow> group) {
        Map<String, List<RunRow>> byLevel = comparison.levels(group);
        List<RunRow> base = byLevel.getOrDefault(levels.get(0), List.of());
        List<String> row = new ArrayList<>(List.of(Html.escape(name)));
        for (int i = 0; i < levels.size(); i++) {
            List<RunRow> runs = byLevel.getOrDefault(levels.get(i), List.of());
            row.add(Html.survivalCell(Survival.of(runs)));
            if (i > 0) {
                row.add(comparison
                        .survival(base, runs)
                        .map(difference -> points(difference, 100))
                        .orElse("&ndash;"));
            }
        }
        return row;
    }

    /** Returns a difference as text, bold if its interval does not contain 0. */
    private static String points(Comparison.Difference difference, double scale) {
        double low = scale * difference.interval().low();
        double high = scale * difference.interval().high();
        String value = scale == 100
                ? signedPoints(scale * difference.value())
                : (difference.value() > 0 ? "+" : "") + Html.number(difference.value());
        String range = scale == 100
                ? signedPoints(low) + " to " + signedPoints(high)
                : Html.number(low) + " to " + Html.number(high);
        boolean clear = low > 0 || high < 0;
        return (clear ? "<b>" + value + "</b>" : value) + "<br><small>" + range + "; "
                + Html.count(difference.pairs(), "pair") + "</small>";
    }

    /** Returns whole percentage points, with a sign unless they are zero. */
    private static String signedPoints(double points) {
        String text = DecimalText.formatFixed(points, 0);
        return points < 0 || text.equals("0") ? text : "+" + text;
    }

    private String forests(Comparison comparison, List<String> levels) {
        StringBuilder out = new StringBuilder();
        for (String level : levels.subList(1, levels.size())) {
            List<String> names = new ArrayList<>();
            List<Comparison.Difference> differences = new ArrayList<>();
            comparison.faultGroups().forEach((name, group) -> {
                Map<String, List<RunRow>> byLevel = comparison.levels(group);
                Optional<Comparison.Difference> difference = comparison.survival(
                        byLevel.getOrDefault(levels.get(0), List.of()), byLevel.getOrDefault(level, List.of()));
                if (difference.isPresent()) {
                    names.add(name);
                    differences.add(difference.get());
                }
            });
            String title = comparison.column() + " " + level + " less " + levels.get(0) + ", percentage points";
            out.append(ReportCharts.differences(title, names, differences));
        }
        return out.toString();
    }

    private String metricTable(Comparison comparison, List<String> levels) {
        List<String> header = new ArrayList<>(List.of("number"));
        levels.forEach(level -> header.add(Html.escape(level)));
        levels.stream().skip(1).forEach(level -> header.add("difference of " + Html.escape(level)));
        Map<String, List<RunRow>> byLevel = comparison.levels(data.rows());
        List<List<String>> rows = new ArrayList<>();
        for (String metric : METRICS) {
            if (data.has(metric)) {
                List<String> row = new ArrayList<>(List.of(metric));
                levels.forEach(level -> row.add(mean(byLevel.get(level), metric)));
                levels.stream()
                        .skip(1)
                        .forEach(level -> row.add(comparison
                                .number(byLevel.get(levels.get(0)), byLevel.get(level), metric)
                                .map(difference -> points(difference, 1))
                                .orElse("&ndash;")));
                rows.add(row);
            }
        }
        return Html.table("numbers", header, rows);
    }

    private static String mean(List<RunRow> rows, String metric) {
        double[] values = RunData.values(rows, metric);
        return values.length == 0
                ? "&ndash;"
                : Html.number(Arrays.stream(values).average().orElse(0)) + " <small>n " + values.length + "</small>";
    }

    /** Returns charts of the share carried on over each number that is drawn or has many levels. */
    String responses() {
        StringBuilder charts = new StringBuilder();
        for (Column column : data.continuousColumns()) {
            responseGroups(column).forEach((name, rows) -> charts.append(response(column, name, rows)));
        }
        return charts.isEmpty()
                ? ""
                : Html.section(
                        "Carried on over drawn numbers",
                        Html.paragraph("Share of runs carried on, with 95 % intervals, in " + BINS
                                        + " equal parts of each range; of all runs in which the number was given.")
                                + "<div class=\"charts\">" + charts + "</div>\n");
    }

    /** Returns the runs by kind of fault, because the meaning of a fault's value depends on its kind. */
    private Map<String, List<RunRow>> responseGroups(Column column) {
        Optional<FactorSummary> faults = data.factor(FactorKind.FAULTS)
                .filter(factor ->
                        factor.columns().contains(column) && column.unit().isEmpty());
        return RunData.group(
                data.rows().stream()
                        .filter(row -> row.number(column.name()).isPresent())
                        .toList(),
                row -> faults.map(factor -> ", " + row.text(RunData.faultColumn(factor)))
                        .orElse(""));
    }

    private String response(Column column, String group, List<RunRow> given) {
        List<RunRow> rows = given.stream()
                .filter(row ->
                        row.number(column.name()).isPresent() && row.carriedOn().isPresent())
                .toList();
        double[] values = RunData.values(rows, column.name());
        double low = Arrays.stream(values).min().orElse(0);
        double high = Arrays.stream(values).max().orElse(1);
        List<ReportCharts.Estimate> points = new ArrayList<>();
        for (int i = 0; i < BINS; i++) {
            double from = low + i * (high - low) / BINS;
            double to = i == BINS - 1 ? Double.POSITIVE_INFINITY : low + (i + 1) * (high - low) / BINS;
            List<RunRow> bin = rows.stream()
                    .filter(row -> row.number(column.name()).getAsDouble() >= from
                            && row.number(column.name()).getAsDouble() < to)
                    .toList();
            Survival survival = Survival.of(bin);
            if (survival.n() > 0) {
                points.add(new ReportCharts.Estimate(
                        low + (i + 0.5) * (high - low) / BINS, survival.share(), survival.interval()));
            }
        }
        return ReportCharts.shares(
                "carried on over " + column.name() + group,
                column.name() + (column.unit().isEmpty() ? "" : " (" + column.unit() + ")") + group,
                low,
                high,
                points);
    }

    /** Returns histograms of the results. */
    String distributions() {
        StringBuilder charts = new StringBuilder();
        for (String metric :
                List.of("coverage", "wall_share", "laps", "distance_rms_m", "follow_rms_m", "simulated_s")) {
            double[] values = RunData.values(data.rows(), metric);
            if (values.length > 0) {
                charts.append(ReportCharts.histogram(metric, values));
            }
        }
        return Html.section("Distributions", "<div class=\"charts\">" + charts + "</div>\n");
    }
}
