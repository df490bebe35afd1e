package faultline.campaign.report;

import java.util.Collection;
import java.util.Locale;
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
     * Returns the share of some runs. Runs in one world are not independent, and a run that repeats another one is no
     * new observation; the interval uses the {@linkplain ClusteredSample#effectiveSize number of independent runs}.
     *
     * @param rows the runs; those without a verdict are ignored
     * @param result returns 1 for a run with the result, 0 for one without it, empty for one without a verdict
     */
    static Survival of(Collection<RunRow> rows, Function<RunRow, OptionalInt> result) {
        ClusteredSample sample = new ClusteredSample();
        int successes = 0;
        for (RunRow row : rows) {
            OptionalInt verdict = result.apply(row);
            if (verdict.isPresent()) {
                sample.add(row.firstEqual(), row.cluster(), verdict.getAsInt());
                successes += verdict.getAsInt();
            }
        }
        int n = sample.size();
        if (n == 0) {
            return new Survival(0, 0, new Interval(0, 1));
        }
        double effectiveSize = sample.effectiveSize();
        // All and none are exact, because their intervals end at 1 and 0.
        double share = (double) successes / n;
        return new Survival(successes, n, Interval.wilson(effectiveSize * share, effectiveSize));
    }

    /**
     * {@return a share in percent, with one decimal above 90, and 100 only for all runs} A share is not outside its
     * interval if both are texts of this form.
     *
     * @param share the share, in [0, 1]
     */
    public static String percentText(double share) {
        return share > 0.9 && share < 1
                ? String.format(Locale.ROOT, "%.1f", Math.min(99.9, 100 * share))
                : String.format(Locale.ROOT, "%.0f", 100 * share);
    }

    /** {@return the share, 0 without runs} */
    public double share() {
        return n == 0 ? 0 : (double) successes / n;
    }
}
