package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

class LowerQuantileTest {

    private static void assertQuantile(double expected, double share, double... values) {
        assertEquals(OptionalDouble.of(expected), LowerQuantile.of(values, share));
    }

    @Test
    void aQuantileIsTheSmallestValueThatEnoughValuesDoNotExceed() {
        assertQuantile(6, 0.5, 6);
        assertQuantile(6, 0.9, 6);
        assertQuantile(4, 0.5, 6, 4);
        assertQuantile(6, 0.9, 6, 4);
        assertQuantile(6, 0.5, 6, 4, 6);
        assertQuantile(9, 0.9, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1);
    }

    @Test
    void theFirstAndLastQuantilesAreTheLeastAndTheGreatestValue() {
        assertQuantile(-1, 0, 3, -1, 2);
        assertQuantile(3, 1, 3, -1, 2);
    }

    @Test
    void noValuesHaveNoQuantile() {
        assertEquals(OptionalDouble.empty(), LowerQuantile.of(new double[0], 0.5));
    }

    @Test
    void theValuesKeepTheirOrder() {
        double[] values = {2, 1};
        LowerQuantile.of(values, 0.5);
        assertArrayEquals(new double[] {2, 1}, values);
    }
}
