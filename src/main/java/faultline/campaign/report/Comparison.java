package faultline.campaign.report;

import faultline.campaign.plan.CampaignPlan.FactorSummary;
import faultline.campaign.plan.Column;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;

/** Compares the levels of one factor on the same worlds, seeds, draws and levels of all other factors. */
final class Comparison {

    /**
     * The maximum number of faults on sensors that are listed individually; more are grouped by fault and by sensor.
     */
    private static final int MAX_GROUPS = 40;

    private final RunData data;
    private final String column;
    private final List<Integer> otherColumns;

    /** A difference with its interval and the number of pairs behind it. */
    record Difference(double value, Interval interval, int pairs) {}

    Comparison(RunData data, FactorSummary factor) {
        this.data = data;
        this.column = factor.columns().get(0).name();
        List<String> own = factor.columns().stream().map(Column::name).toList();
        this.otherColumns = data.plan().factorColumns().stream()
                .map(Column::name)
                .filter(name -> !own.contains(name))
                .map(data::index)
                .toList();
    }

    String column() {
        return column;
    }

    /** Returns the levels in the order of the plan. */
    Map<String, List<RunRow>> levels(List<RunRow> rows) {
        return RunData.group(rows, row -> row.text(column));
    }

    private String pairKey(RunRow row) {
        StringBuilder key = new StringBuilder(row.text("block"));
        otherColumns.forEach(index -> key.append('\t').append(row.cells().get(index)));
        return key.toString();
    }

    private List<RunRow[]> pairs(List<RunRow> first, List<RunRow> second) {
        Map<String, RunRow> partners = new HashMap<>();
        first.forEach(row -> partners.put(pairKey(row), row));
        List<RunRow[]> pairs = new ArrayList<>();
        for (RunRow row : second) {
            Optional.ofNullable(partners.get(pairKey(row)))
                    .ifPresent(partner -> pairs.add(new RunRow[] {partner, row}));
        }
        return pairs;
    }

    /** Returns the difference between the shares of the second and the first runs in which the robot carries on. */
    Optional<Difference> survival(List<RunRow> first, List<RunRow> second) {
        List<RunRow[]> pairs = pairs(first, second).stream()
                .filter(pair ->
                        pair[0].carriedOn().isPresent() && pair[1].carriedOn().isPresent())
                .toList();
        if (pairs.isEmpty()) {
            return Optional.empty();
        }
        double[] counts = new double[4];
        for (RunRow[] pair : pairs) {
            counts[2 * pair[1].carriedOn().getAsInt() + pair[0].carriedOn().getAsInt()]++;
        }
        double worth = 1 / designEffect(pairs);
        Interval interval =
                Interval.pairedDifference(worth * counts[3], worth * counts[2], worth * counts[1], worth * counts[0]);
        return Optional.of(new Difference((counts[2] - counts[1]) / pairs.size(), interval, pairs.size()));
    }

    private static double designEffect(List<RunRow[]> pairs) {
        double mean = pairs.stream().mapToDouble(Comparison::gain).average().orElse(0);
        double squares = 0;
        Map<String, Double> sums = new LinkedHashMap<>();
        for (RunRow[] pair : pairs) {
            double deviation = gain(pair) - mean;
            squares += deviation * deviation;
            sums.merge(pair[0].cluster(), deviation, Double::sum);
        }
        return Survival.designEffect(pairs.size(), sums, squares);
    }

    private static double gain(RunRow[] pair) {
        return pair[1].carriedOn().getAsInt() - pair[0].carriedOn().getAsInt();
    }

    /** Returns the mean difference of a number, by Student's t over the means of the worlds. */
    Optional<Difference> number(List<RunRow> first, List<RunRow> second, String metric) {
        Function<RunRow, OptionalDouble> value = row -> row.number(metric);
        Map<String, List<Double>> clusters = new LinkedHashMap<>();
        int pairs = 0;
        for (RunRow[] pair : pairs(first, second)) {
            OptionalDouble a = value.apply(pair[0]);
            OptionalDouble b = value.apply(pair[1]);
            if (a.isPresent() && b.isPresent()) {
                clusters.computeIfAbsent(pair[0].cluster(), key -> new ArrayList<>())
                        .add(b.getAsDouble() - a.getAsDouble());
                pairs++;
            }
        }
        if (pairs == 0) {
            return Optional.empty();
        }
        double[] means = clusters.values().stream()
                .mapToDouble(list ->
                        list.stream().mapToDouble(Double::doubleValue).average().orElse(0))
                .toArray();
        double mean = java.util.Arrays.stream(means).average().orElse(0);
        double squares =
                java.util.Arrays.stream(means).map(x -> (x - mean) * (x - mean)).sum();
        double deviation = means.length < 2 ? 0 : Math.sqrt(squares / (means.length - 1));
        return Optional.of(new Difference(mean, Interval.mean(mean, deviation, means.length), pairs));
    }

    /** Returns the runs of each fault, all of them under "all runs" first. */
    Map<String, List<RunRow>> faultGroups() {
        Map<String, List<RunRow>> groups = new LinkedHashMap<>();
        groups.put("all runs", data.rows());
        Map<String, List<RunRow>> faults = RunData.group(data.rows(), data::faultName);
        if (faults.size() > MAX_GROUPS) {
            groups.putAll(RunData.group(data.rows(), data::faultKind));
            groups.putAll(RunData.group(data.rows(), data::failingPart));
        } else if (faults.size() > 1) {
            groups.putAll(faults);
        }
        return groups;
    }
}
