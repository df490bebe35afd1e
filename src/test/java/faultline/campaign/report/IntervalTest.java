package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class IntervalTest {

    /** From Newcombe (1998), Statistics in Medicine 17, table I: method 3. */
    @ParameterizedTest
    @CsvSource({"81, 263, 0.2553, 0.3662", "15, 148, 0.0624, 0.1605", "0, 20, 0, 0.1611", "1, 29, 0.0061, 0.1718"})
    void wilsonIntervalsAreThoseOfTheLiterature(int successes, int n, double low, double high) {
        Interval interval = Interval.wilson(successes, n);
        assertEquals(low, interval.low(), 5e-5);
        assertEquals(high, interval.high(), 5e-5);
    }

    @Test
    void theIntervalOfNoneBeginsAtZeroAndThatOfAllEndsAtOne() {
        for (int n = 1; n <= 400; n++) {
            assertEquals(0, Interval.wilson(0, n).low());
            assertEquals(1, Interval.wilson(n, n).high());
        }
    }

    /** From a numerical integration of the density. */
    @ParameterizedTest
    @CsvSource({
        "1, 12.706204736",
        "2, 4.302652730",
        "3, 3.182446305",
        "4, 2.776445105",
        "5, 2.570581836",
        "10, 2.228138852",
        "29, 2.045229642",
        "30, 2.042272456",
        "31, 2.039513446",
        "40, 2.021075390",
        "100, 1.983971519",
        "1000, 1.962339081"
    })
    void quantilesOfStudentAreThoseOfTheTables(int freedom, double quantile) {
        assertEquals(quantile, Interval.studentQuantile(freedom), 5e-8);
    }

    /**
     * The first row is an example of Newcombe (1998), Statistics in Medicine 17, method 10; the others were computed by
     * the roots of the equation of each score interval.
     */
    @ParameterizedTest
    @CsvSource({
        "36, 12, 2, 0, 0.056930, 0.340428",
        "20, 5, 3, 12, -0.092575, 0.188904",
        "3, 2, 1, 2, -0.302817, 0.496241",
        "5, 9, 6, 2, -0.195438, 0.434786",
        "0, 1, 0, 0, -0.122109, 1",
        "1, 1, 0, 0, -0.272573, 0.905469",
        "0, 0, 3, 2, -0.882379, -0.029790",
        "12.5, 2.5, 1.25, 8.75, -0.111974, 0.206658"
    })
    void intervalsOfPairedDifferencesAreThoseOfMethodTen(
            double both, double first, double second, double neither, double low, double high) {
        Interval interval = Interval.pairedDifference(both, first, second, neither);
        assertEquals(low, interval.low(), 1e-6);
        assertEquals(high, interval.high(), 1e-6);
        Interval exchanged = Interval.pairedDifference(both, second, first, neither);
        assertEquals(-high, exchanged.low(), 1e-6);
        assertEquals(-low, exchanged.high(), 1e-6);
    }

    @Test
    void theMeanOfOneObservationHasNoInterval() {
        assertEquals(new Interval(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY), Interval.mean(2, 0, 1));
        // Of 1 and 3: the deviation is the square root of 2, so the half width is the quantile itself.
        Interval two = Interval.mean(2, Math.sqrt(2), 2);
        assertEquals(2 - 12.706204736, two.low(), 1e-8);
        assertEquals(2 + 12.706204736, two.high(), 1e-8);
    }

    @Test
    void equalVariantsDifferByNothingWithAnInterval() {
        Interval interval = Interval.pairedDifference(60, 0, 0, 0);
        assertTrue(interval.low() < -0.03 && interval.high() > 0.03);
        assertEquals(-interval.low(), interval.high(), 1e-12);
    }

    @Test
    void pairedIntervalsHoldTheTrueDifferenceInAboutNineteenOfTwentyCampaigns() {
        Random random = new Random(1);
        int held = 0;
        for (int campaign = 0; campaign < 4000; campaign++) {
            double[] counts = new double[4];
            for (int pair = 0; pair < 40; pair++) {
                // The second is as good as the first, or avoids a fifth of its failures.
                boolean first = random.nextDouble() < 0.7;
                boolean second = first || random.nextDouble() < 0.2;
                counts[(first ? 1 : 0) + (second ? 2 : 0)]++;
            }
            Interval interval = Interval.pairedDifference(counts[3], counts[2], counts[1], counts[0]);
            held += interval.low() <= 0.06 && interval.high() >= 0.06 ? 1 : 0;
        }
        assertTrue(held / 4000.0 > 0.93, "only " + held / 4000.0);
    }
}
