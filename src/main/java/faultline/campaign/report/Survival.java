package faultline.campaign.report;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.function.Function;

/**
 * The share of runs with a given result, such as those in which the robot carried on.
 *
 * @param successes the number of runs with the result
 * @param n the number of runs with a verdict
 * @param interval the interval of the share
 */
public record Survival(int successes, int n, Interval interval) {

    /** Returns the share of some runs in which the robot carried on, see {@link #of(Collection, Function)}. */
    static Survival of(Collection<RunRow> rows) {
        return of(rows, RunRow::carriedOn);
    }

    /**
     * Returns the share of some runs. Runs in one world are not independent; the interval uses the effective number of
     * independent runs: the number of runs divided by the ratio of the variance of the share between worlds to that of
     * independent runs.
     *
     * @param rows the runs; those without a verdict are ignored
     * @param result returns 1 for a run with the result, 0 for one without it, empty for one without a verdict
     */
    static Survival of(Collection<RunRow> rows, Function<RunRow, OptionalInt> result) {
        List<RunRow> decided =
                rows.stream().filter(row -> result.apply(row).isPresent()).toList();
        if (decided.isEmpty()) {
            return new Survival(0, 0, new Interval(0, 1));
        }
        int n = decided.size();
        int successes =
                decided.stream().mapToInt(row -> result.apply(row).getAsInt()).sum();
        double share = (double) successes / n;
        Map<String, Double> sums = new LinkedHashMap<>();
        decided.forEach(row -> sums.merge(row.cluster(), result.apply(row).getAsInt() - share, Double::sum));
        double worth = n / designEffect(n, sums, n * share * (1 - share));
        return new Survival(successes, n, Interval.wilson(worth * share, worth));
    }

    /**
     * Returns the design effect, at least 1: the ratio of the number of runs to the effective number of independent
     * runs. If no runs differ, the effective number is the number of worlds.
     *
     * @param n the number of runs
     * @param sums the sums of the deviations from the mean in each world
     * @param squares the sum of all squared deviations
     */
    static double designEffect(int n, Map<String, Double> sums, double squares) {
        int worlds = sums.size();
        if (n == worlds || worlds == 1) {
            return n == worlds ? 1 : n;
        }
        double clustered = sums.values().stream().mapToDouble(sum -> sum * sum).sum() * worlds / (worlds - 1);
        return squares > 1e-12 ? Math.max(1, clustered / squares) : (double) n / worlds;
    }

    /** {@return the share, 0 without runs} */
    public double share() {
        return n == 0 ? 0 : (double) successes / n;
    }
}
