package faultline.studies.figure;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SortedSampleTest {

    private static SortedSample of(double... values) {
        return SortedSample.of(DoubleStream.of(values));
    }

    /** The interpolated quantiles of 4, 1, 2 and 8: the second of three steps ends at 4. */
    @ParameterizedTest
    @CsvSource({"0, 1", "0.5, 3", "0.05, 1.15", "0.95, 7.4", "1, 8"})
    void quantilesAreInterpolated(double share, double quantile) {
        assertEquals(quantile, of(4, 1, 2, 8).quantile(share), 1e-12);
    }

    @Test
    void valuesThatAreEqualOrFewHaveQuantilesToo() {
        assertEquals(Double.NaN, of().quantile(0.5));
        assertEquals(Double.NaN, of().rms());
        assertEquals(7, of(7).quantile(0.05));
        assertEquals(7, of(7).quantile(0.95));
        assertEquals(1.5, of(2, 1).median());
        assertEquals(2, of(1, 2, 2, 2, 3).median());
        assertEquals(2, of(1, 2, 2, 2, 3).quantile(0.3));
    }

    @Test
    void valuesThatAreNotFiniteAreOmitted() {
        SortedSample sample = of(Double.NaN, 3, Double.POSITIVE_INFINITY, -4, Double.NEGATIVE_INFINITY);
        assertEquals(2, sample.size());
        assertEquals(-4, sample.min());
        assertEquals(3, sample.max());
        assertEquals(Math.sqrt(12.5), sample.rms(), 1e-12);
    }

    @Test
    void magnitudesBeyondALimitAreCounted() {
        assertEquals(2, of(-6, -5, 0, 5, 5.1).countBeyond(5));
    }
}
