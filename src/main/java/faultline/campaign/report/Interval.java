package faultline.campaign.report;

/**
 * A 95 % confidence interval.
 *
 * @param low its lower end
 * @param high its upper end
 */
public record Interval(double low, double high) {

    /** The 0.975 quantile of the normal distribution. */
    static final double NORMAL_QUANTILE = 1.959963984540054;

    private static final double Z = NORMAL_QUANTILE;

    /**
     * {@return the interval of a share by Wilson (1927)} It is within [0, 1] and also valid for few runs. With no
     * success it begins at 0; with successes only it ends at 1.
     *
     * @param successes the successes, not necessarily whole, in [0, n]
     * @param n the number of trials, positive
     */
    public static Interval wilson(double successes, double n) {
        double p = successes / n;
        double centre = p + Z * Z / (2 * n);
        double half = Z * Math.sqrt(p * (1 - p) / n + Z * Z / (4 * n * n));
        double scale = 1 + Z * Z / n;
        // At these ends, the terms below cancel up to rounding.
        double low = successes == 0 ? 0 : Math.max(0, (centre - half) / scale);
        double high = successes == n ? 1 : Math.min(1, (centre + half) / scale);
        return new Interval(low, high);
    }

    /**
     * Returns the interval of the difference of two shares of the same pairs by Newcombe (1998), method 10: the square
     * root of squared Wilson distances, less twice their product by the correlation, which is corrected for continuity.
     *
     * @param both pairs in which both succeed
     * @param first pairs in which only the first does
     * @param second pairs in which only the second does
     * @param neither pairs in which none does
     */
    static Interval pairedDifference(double both, double first, double second, double neither) {
        double n = both + first + second + neither;
        double p1 = (both + first) / n;
        double p2 = (both + second) / n;
        Interval one = wilson(both + first, n);
        Interval two = wilson(both + second, n);
        double margins = (both + first) * (second + neither) * (both + second) * (first + neither);
        double association = both * neither - first * second;
        double corrected = association > 0 ? Math.max(0, association - n / 2) : association;
        double phi = margins > 0 ? corrected / Math.sqrt(margins) : 0;
        double difference = p1 - p2;
        return new Interval(
                difference - combine(p1 - one.low, two.high - p2, phi),
                difference + combine(one.high - p1, p2 - two.low, phi));
    }

    private static double combine(double a, double b, double phi) {
        return Math.sqrt(Math.max(0, a * a - 2 * phi * a * b + b * b));
    }

    /**
     * Returns the interval of a mean of independent observations by Student's t, given the standard deviation of one
     * observation; it is unbounded with fewer than two.
     */
    static Interval mean(double mean, double deviation, int n) {
        if (n < 2) {
            return new Interval(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
        }
        double half = studentQuantile(n - 1) * deviation / Math.sqrt(n);
        return new Interval(mean - half, mean + half);
    }

    /**
     * Returns the 0.975 quantile of Student's t to seven digits: by its distribution function, and from 30 degrees of
     * freedom on by Cornish and Fisher's expansion.
     */
    static double studentQuantile(int freedom) {
        if (freedom >= 30) {
            return expandedQuantile(freedom);
        }
        double low = Z;
        double high = 13;
        for (int i = 0; i < 60; i++) {
            double middle = (low + high) / 2;
            if (shareWithin(middle, freedom) < 0.95) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return (low + high) / 2;
    }

    /** Returns the probability that |t| is below a limit (Abramowitz and Stegun 1964, 26.7.3 and 26.7.4). */
    private static double shareWithin(double limit, int freedom) {
        double cosine2 = freedom / (freedom + limit * limit);
        boolean odd = freedom % 2 == 1;
        double term = odd ? Math.sqrt(cosine2) : 1;
        double sum = freedom == 1 ? 0 : term;
        for (int i = odd ? 2 : 1; i <= freedom - 3; i += 2) {
            term *= cosine2 * i / (i + 1);
            sum += term;
        }
        double sine = Math.sqrt(1 - cosine2);
        double angle = StrictMath.atan(limit / Math.sqrt(freedom));
        return odd ? 2 / Math.PI * (angle + sine * sum) : sine * sum;
    }

    private static double expandedQuantile(int freedom) {
        double z3 = Z * Z * Z;
        double z5 = z3 * Z * Z;
        double z7 = z5 * Z * Z;
        double z9 = z7 * Z * Z;
        double v = freedom;
        return Z
                + (z3 + Z) / (4 * v)
                + (5 * z5 + 16 * z3 + 3 * Z) / (96 * v * v)
                + (3 * z7 + 19 * z5 + 17 * z3 - 15 * Z) / (384 * v * v * v)
                + (79 * z9 + 776 * z7 + 1482 * z5 - 1920 * z3 - 945 * Z) / (92_160 * v * v * v * v);
    }
}
