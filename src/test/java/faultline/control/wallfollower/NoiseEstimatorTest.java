package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.sensor.Reading;
import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NoiseEstimatorTest {

    private static double estimate(DoubleStream readings) {
        NoiseEstimator meter = new NoiseEstimator();
        readings.forEach(meter::update);
        return meter.standardDeviation();
    }

    @Test
    void atFirstNoNoiseIsKnown() {
        assertEquals(0, estimate(DoubleStream.empty()));
        assertEquals(0, estimate(DoubleStream.of(0.3, 0.4)));
    }

    @Test
    void aSteadyApproachIsNoNoise() {
        assertEquals(
                0,
                estimate(DoubleStream.iterate(0.8, reading -> reading - 0.003).limit(200)),
                1e-12);
    }

    @Test
    void readingsThatJumpToAndFroBy2MillimetresHaveThirdDifferencesOf8() {
        assertEquals(0.008 / Math.sqrt(20), estimate(DoubleStream.of(0.3, 0.302, 0.3, 0.302, 0.3)), 1e-9);
    }

    @Test
    void aSpinPastAWallInStepsOf3DegreesIsLittleNoise() {
        DoubleStream readings = DoubleStream.iterate(-40, degrees -> degrees + 3)
                .limit(27)
                .map(degrees -> 0.25 / Math.cos(Math.toRadians(degrees)));
        assertEquals(0, estimate(readings), 0.0001);
    }

    @Test
    void gaussianNoiseOnAnApproachIsMeasured() {
        SplittableRandom random = new SplittableRandom(1);
        double[] mean = {0};
        for (int run = 0; run < 50; run++) {
            mean[0] += estimate(DoubleStream.iterate(0.8, reading -> reading - 0.001)
                            .limit(300)
                            .map(reading -> reading + 0.002 * gaussian(random)))
                    / 50;
        }
        assertEquals(0.002, mean[0], 0.0001);
    }

    @ParameterizedTest
    @CsvSource({"4, 4.0", "8, 7.4", "10, 8.3", "15, 9.4", "20, 9.8", "50, 10.3"})
    void theEstimateOfStrongNoiseStaysBelowElevenMillimetres(double millimetres, double estimated) {
        SplittableRandom random = new SplittableRandom(2);
        double sum = 0;
        int runs = 100;
        for (int run = 0; run < runs; run++) {
            sum += estimate(DoubleStream.generate(() -> 0.5 + millimetres / 1000 * gaussian(random))
                    .limit(1000));
        }
        assertEquals(estimated, 1000 * sum / runs, 0.1);
    }

    /** The sum of twelve even ones is near enough to a normal one. */
    private static double gaussian(SplittableRandom random) {
        return random.doubles(12).sum() - 6;
    }

    @Test
    void somethingElseComingIntoSightIsNoNoise() {
        assertEquals(0, estimate(DoubleStream.of(0.7, 0.7, 0.7, 0.2, 0.2, 0.2, Reading.NOTHING, 0.5, 0.5, 0.5)), 1e-12);
    }

    @Test
    void nothingInSightTeachesNothing() {
        assertEquals(0, estimate(DoubleStream.of(Reading.NOTHING, Reading.NOTHING, Reading.NOTHING, Reading.OFF, 0.3)));
    }
}
