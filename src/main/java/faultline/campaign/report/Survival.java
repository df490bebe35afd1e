package faultline.campaign.report;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.function.Function;

/**
 * The share of runs with a result that is wanted, such as those in which the robot carried on.
 *
 * @param successes runs with the result
 * @param n runs with a verdict
 * @param interval of the share
 */
public record Survival(int successes, int n, Interval interval) {

    /** Returns the share of some runs in which the robot carried on, see {@link #of(Collection, Function)}. */
    static Survival of(Collection<RunRow> rows) {
        return of(rows, RunRow::carriedOn);
    }

    /**
     * Returns the share of some runs. Runs in one world are not independent; the interval is that of as many
     * independent runs as they are worth: their number by the ratio of the variance of the share between worlds to that
     * of independent runs.
     *
     * @param rows the runs; those without a verdict are left out
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
     * Returns by how much runs in few worlds are worth less than independent ones, at least 1. Runs that do not differ
     * at all are worth one for each world.
     *
     * @param n how many runs there are
     * @param sums of the deviations from the mean in each world
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
