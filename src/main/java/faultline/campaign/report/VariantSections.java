package faultline.campaign.report;

import faultline.campaign.plan.CampaignPlan.FactorSummary;
import faultline.campaign.plan.Column;
import faultline.io.DecimalText;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The sections on factors: levels side by side, and shares over drawn numbers. */
final class VariantSections {

    /** The numbers that are compared in addition to the share of runs carried on, by their columns. */
    private static final List<String> METRICS =
            List.of("coverage", "distance_rms_m", "follow_rms_m", "wall_share", "laps", "detection_delay_s");

    private static final int BINS = 10;

    /** The maximum number of charts over drawn numbers; a page with more would be long and hard to read. */
    private static final int MAX_RESPONSES = 100;

    private final CampaignRuns campaign;

    VariantSections(CampaignRuns campaign) {
        this.campaign = campaign;
    }

    /** Returns a section for each compared factor. */
    String comparisons() {
        StringBuilder out = new StringBuilder();
        for (FactorSummary factor : campaign.comparedFactors()) {
            Comparison comparison = new Comparison(campaign, factor);
            List<String> levels = List.copyOf(comparison.levels(campaign.rows()).keySet());
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
                + survivals(comparison, levels)
                + Html.paragraph("Means of other numbers, and their paired differences to " + levels.get(0)
                        + " with 95 % intervals (Student's t over "
                        + (campaign.worldCount() > 1 ? "worlds" : "seeds and draws") + ").")
                + metricTable(comparison, levels);
    }

    /** The runs of a group at each level, and the differences of levels from the first, where there are pairs. */
    private record LevelGroup(
            String name, Map<String, List<RunRow>> runs, Map<String, Comparison.Difference> differences) {}

    private static List<LevelGroup> levelGroups(Comparison comparison, List<String> levels) {
        List<LevelGroup> groups = new ArrayList<>();
        for (Comparison.RunGroup group : comparison.faultGroups()) {
            Map<String, List<RunRow>> runs = comparison.levels(group.runs());
            List<RunRow> base = runs.getOrDefault(levels.get(0), List.of());
            Map<String, Comparison.Difference> differences = new HashMap<>();
            for (String level : levels.subList(1, levels.size())) {
                comparison
                        .survival(base, runs.getOrDefault(level, List.of()))
                        .ifPresent(difference -> differences.put(level, difference));
            }
            groups.add(new LevelGroup(group.name(), runs, differences));
        }
        return groups;
    }

    /** Returns the table of shares and differences, and the charts of the differences. */
    private static String survivals(Comparison comparison, List<String> levels) {
        List<LevelGroup> groups = levelGroups(comparison, levels);
        List<String> header = new ArrayList<>(List.of("runs"));
        for (int i = 0; i < levels.size(); i++) {
            header.add(Html.escape(levels.get(i)));
            if (i > 0) {
                header.add("difference");
            }
        }
        List<List<String>> rows =
                groups.stream().map(group -> survivalRow(group, levels)).toList();
        return Html.table("matrix", header, rows) + forests(comparison.column(), levels, groups);
    }

    private static List<String> survivalRow(LevelGroup group, List<String> levels) {
        List<String> row = new ArrayList<>(List.of(Html.escape(group.name())));
        for (String level : levels) {
            row.add(Html.survivalCell(Survival.of(group.runs().getOrDefault(level, List.of()))));
            if (!level.equals(levels.get(0))) {
                Comparison.Difference difference = group.differences().get(level);
                row.add(difference == null ? "&ndash;" : points(difference, 100));
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
        boolean clear = low > 0 || high < 0;
        return (clear ? "<b>" + value + "</b>" : value) + "<br><small>" + range(low, high, scale)
                + Html.count(difference.pairs(), "pair") + "</small>";
    }

    /** Returns an interval and a separator; empty for that of a single world, which is unbounded. */
    private static String range(double low, double high, double scale) {
        if (Double.isInfinite(low) || Double.isInfinite(high)) {
            return "";
        }
        return scale == 100
                ? signedPoints(low) + " to " + signedPoints(high) + "; "
                : Html.number(low) + " to " + Html.number(high) + "; ";
    }

    /** Returns whole percentage points, with a sign unless they are zero. */
    private static String signedPoints(double points) {
        String text = DecimalText.formatFixed(points, 0);
        return points < 0 || text.equals("0") ? text : "+" + text;
    }

    private static String forests(String column, List<String> levels, List<LevelGroup> groups) {
        StringBuilder out = new StringBuilder();
        for (String level : levels.subList(1, levels.size())) {
            List<LevelGroup> compared = groups.stream()
                    .filter(group -> group.differences().containsKey(level))
                    .toList();
            out.append(ReportCharts.differences(
                    column + " " + level + " less " + levels.get(0) + ", percentage points",
                    compared.stream().map(LevelGroup::name).toList(),
                    compared.stream()
                            .map(group -> group.differences().get(level))
                            .toList()));
        }
        return out.toString();
    }

    private String metricTable(Comparison comparison, List<String> levels) {
        List<String> header = new ArrayList<>(List.of("number"));
        levels.forEach(level -> header.add(Html.escape(level)));
        levels.stream().skip(1).forEach(level -> header.add("difference of " + Html.escape(level)));
        Map<String, List<RunRow>> byLevel = comparison.levels(campaign.rows());
        List<List<String>> rows = new ArrayList<>();
        for (String metric : METRICS) {
            if (campaign.has(metric)) {
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
        double[] values = CampaignRuns.values(rows, metric);
        return values.length == 0
                ? "&ndash;"
                : Html.number(Arrays.stream(values).average().orElse(0)) + " <small>n " + values.length + "</small>";
    }

    /** Returns charts of the share carried on over each number that is drawn or has many levels. */
    String responses() {
        StringBuilder charts = new StringBuilder();
        int count = 0;
        for (Column column : campaign.continuousColumns()) {
            for (Map.Entry<String, List<RunRow>> group : responseGroups(column).entrySet()) {
                count++;
                charts.append(count > MAX_RESPONSES ? "" : response(column, group.getKey(), group.getValue()));
            }
        }
        String omitted = count <= MAX_RESPONSES
                ? ""
                : Html.paragraph("These are the first " + MAX_RESPONSES + " charts of " + count + ". The other "
                        + (count - MAX_RESPONSES) + " are left out.");
        return charts.isEmpty()
                ? ""
                : Html.section(
                        "Carried on over drawn numbers",
                        Html.paragraph("Share of runs carried on, with 95 % intervals, in " + BINS
                                        + " equal parts of each range; of all runs in which the number was given.")
                                + omitted
                                + "<div class=\"charts\">" + charts + "</div>\n");
    }

    /** Returns the runs by kind of fault, because the meaning of a fault's value depends on its kind. */
    private Map<String, List<RunRow>> responseGroups(Column column) {
        Optional<FaultColumns> faults = campaign.faults().stream()
                .filter(columns ->
                        columns.all().contains(column.name()) && column.unit().isEmpty())
                .findFirst();
        return CampaignRuns.group(
                campaign.rows().stream()
                        .filter(row -> row.number(column.name()).isPresent())
                        .toList(),
                row -> faults.map(columns -> ", " + row.text(columns.kind())).orElse(""));
    }

    private String response(Column column, String group, List<RunRow> given) {
        List<RunRow> rows =
                given.stream().filter(row -> row.carriedOn().isPresent()).toList();
        double[] values = CampaignRuns.values(rows, column.name());
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
            double[] values = CampaignRuns.values(campaign.rows(), metric);
            if (values.length > 0) {
                charts.append(ReportCharts.histogram(metric, values));
            }
        }
        return Html.section("Distributions", "<div class=\"charts\">" + charts + "</div>\n");
    }
}
