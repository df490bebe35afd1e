package faultline.campaign.report;

import java.util.Arrays;
import java.util.OptionalDouble;

/**
 * Quantiles of numbers that are numbers of the sample: the median of an even number of them is the lower middle one.
 */
public final class LowerQuantile {

    private LowerQuantile() {}

    /**
     * {@return the smallest value such that at least a given share of the values are not greater; empty if there are
     * none}
     *
     * @param values the values in any order, which are not changed
     * @param share the share, in [0, 1]; 0 for the smallest value, 1 for the greatest
     */
    public static OptionalDouble of(double[] values, double share) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        int index = (int) Math.max(0, Math.ceil(share * sorted.length) - 1);
        return sorted.length == 0 ? OptionalDouble.empty() : OptionalDouble.of(sorted[index]);
    }
}
