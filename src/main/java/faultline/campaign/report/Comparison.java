package faultline.campaign.report;

import faultline.campaign.plan.CampaignPlan.FactorSummary;
import faultline.campaign.plan.Column;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Function;

/** Compares the levels of one factor on the same worlds, seeds, draws and levels of all other factors. */
final class Comparison {

    /**
     * The maximum number of faults on sensors that are listed individually; more are grouped by fault and by sensor.
     */
    private static final int MAX_GROUPS = 40;

    private final CampaignRuns campaign;
    private final String column;
    private final List<Integer> otherColumns;

    /** A difference with its interval and the number of pairs behind it. */
    record Difference(double value, Interval interval, int pairs) {}

    /** Two runs that differ in the compared factor only. */
    private record Pair(RunRow first, RunRow second) {

        boolean hasVerdicts() {
            return first.carriedOn().isPresent() && second.carriedOn().isPresent();
        }

        /** Returns 1 if the robot carries on in the second run only, -1 if in the first only, otherwise 0. */
        double gain() {
            return second.carriedOn().getAsInt() - first.carriedOn().getAsInt();
        }

        void addTo(ClusteredSample sample, double value) {
            sample.add(List.of(first.firstEqual(), second.firstEqual()), first.cluster(), value);
        }
    }

    Comparison(CampaignRuns campaign, FactorSummary factor) {
        this.campaign = campaign;
        this.column = factor.columns().get(0).name();
        List<String> own = factor.columns().stream().map(Column::name).toList();
        this.otherColumns = campaign.plan().factorColumns().stream()
                .map(Column::name)
                .filter(name -> !own.contains(name))
                .map(campaign::index)
                .toList();
    }

    String column() {
        return column;
    }

    /**
     * Returns the rows of each level, in the order of the plan, also if a part of a campaign begins with a later one.
     */
    Map<String, List<RunRow>> levels(List<RunRow> rows) {
        Map<String, List<RunRow>> levels = new LinkedHashMap<>();
        CampaignRuns.group(rows, row -> row.text(column)).entrySet().stream()
                .sorted(Comparator.comparingLong(level -> firstCell(level.getValue())))
                .forEach(level -> levels.put(level.getKey(), level.getValue()));
        return levels;
    }

    /** Returns the index of the first cell of the plan that some rows belong to. */
    private long firstCell(List<RunRow> rows) {
        return rows.stream()
                .mapToLong(
                        row -> Long.parseLong(row.text("run")) % campaign.plan().cellCount())
                .min()
                .orElseThrow();
    }

    private String pairKey(RunRow row) {
        StringBuilder key = new StringBuilder(row.text("block"));
        otherColumns.forEach(index -> key.append('\t').append(row.cells().get(index)));
        return key.toString();
    }

    private List<Pair> pairs(List<RunRow> first, List<RunRow> second) {
        Map<String, RunRow> partners = new HashMap<>();
        first.forEach(row -> partners.put(pairKey(row), row));
        List<Pair> pairs = new ArrayList<>();
        for (RunRow row : second) {
            Optional.ofNullable(partners.get(pairKey(row))).ifPresent(partner -> pairs.add(new Pair(partner, row)));
        }
        return pairs;
    }

    /** Returns the difference between the shares of the second and the first runs in which the robot carries on. */
    Optional<Difference> survival(List<RunRow> first, List<RunRow> second) {
        List<Pair> pairs =
                pairs(first, second).stream().filter(Pair::hasVerdicts).toList();
        if (pairs.isEmpty()) {
            return Optional.empty();
        }
        double both = count(pairs, 1, 1);
        double onlySecond = count(pairs, 0, 1);
        double onlyFirst = count(pairs, 1, 0);
        double neither = count(pairs, 0, 0);
        ClusteredSample gains = new ClusteredSample();
        pairs.forEach(pair -> pair.addTo(gains, pair.gain()));
        double sharePerPair = gains.effectiveSize() / pairs.size();
        Interval interval = Interval.pairedDifference(
                sharePerPair * both, sharePerPair * onlySecond, sharePerPair * onlyFirst, sharePerPair * neither);
        return Optional.of(new Difference((onlySecond - onlyFirst) / pairs.size(), interval, pairs.size()));
    }

    /** Counts the pairs in which each run carries on, 1, or not, 0. */
    private static double count(List<Pair> pairs, int first, int second) {
        return pairs.stream()
                .filter(pair -> pair.first.carriedOn().getAsInt() == first
                        && pair.second.carriedOn().getAsInt() == second)
                .count();
    }

    /** Returns the mean difference of a number, by Student's t over the means of the worlds. */
    Optional<Difference> number(List<RunRow> first, List<RunRow> second, String metric) {
        ClusteredSample sample = new ClusteredSample();
        for (Pair pair : pairs(first, second)) {
            OptionalDouble a = pair.first.number(metric);
            OptionalDouble b = pair.second.number(metric);
            if (a.isPresent() && b.isPresent()) {
                pair.addTo(sample, b.getAsDouble() - a.getAsDouble());
            }
        }
        if (sample.size() == 0) {
            return Optional.empty();
        }
        double[] means = sample.clusterMeans();
        double mean = Arrays.stream(means).average().orElse(0);
        double squares = Arrays.stream(means).map(x -> (x - mean) * (x - mean)).sum();
        double deviation = means.length < 2 ? 0 : Math.sqrt(squares / (means.length - 1));
        return Optional.of(new Difference(mean, Interval.mean(mean, deviation, means.length), sample.size()));
    }

    /** Runs under the name that they have in a table; another group may have the same name. */
    record RunGroup(String name, List<RunRow> runs) {}

    /** Returns the runs of each fault or pair of faults, all of them under "all runs" first. */
    Set<RunGroup> faultGroups() {
        Set<RunGroup> groups = new LinkedHashSet<>();
        groups.add(new RunGroup("all runs", campaign.rows()));
        Set<RunGroup> faults = groups(campaign::faultName);
        if (faults.size() > MAX_GROUPS) {
            groups.addAll(groups(campaign::faultKind));
            if (campaign.faults().size() == 1) {
                groups.addAll(groups(campaign::failingPart));
            }
        } else if (faults.size() > 1) {
            groups.addAll(faults);
        }
        return groups;
    }

    private Set<RunGroup> groups(Function<RunRow, String> name) {
        Set<RunGroup> groups = new LinkedHashSet<>();
        CampaignRuns.group(campaign.rows(), name).forEach((key, runs) -> groups.add(new RunGroup(key, runs)));
        return groups;
    }
}
