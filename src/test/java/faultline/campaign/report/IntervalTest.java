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

    @ParameterizedTest
    @CsvSource({
        "1, 12.706205",
        "2, 4.302653",
        "3, 3.182446",
        "4, 2.776445",
        "5, 2.570582",
        "10, 2.228139",
        "29, 2.045230",
        "30, 2.042272",
        "1000, 1.962339"
    })
    void quantilesOfStudentAreThoseOfTheTables(int freedom, double quantile) {
        assertEquals(quantile, Interval.studentQuantile(freedom), 1e-6);
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
