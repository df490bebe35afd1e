package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class RunSummaryTest {

    @Test
    void numbersAreRoundedAsAFormatterRoundsThem() {
        SplittableRandom random = new SplittableRandom(905);
        for (int trial = 0; trial < 20_000; trial++) {
            double value = Math.pow(10, random.nextDouble(-9, 6));
            int digits = random.nextInt(1, 8);
            double half = Math.floor(value * 1000) / 1000 + 0.0005;
            assertEquals(
                    String.format(Locale.ROOT, "%." + digits + "f", value), RunSummary.formatNumber(value, digits));
            assertEquals(String.format(Locale.ROOT, "%.3f", half), RunSummary.formatNumber(half, 3));
        }
        assertEquals("0.0000", RunSummary.formatNumber(0, 4));
        assertEquals("none", RunSummary.formatNumber(Double.NaN, 4));
    }
}
