package faultline.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;

/**
 * Tests that the first draws of many ticks, which the sensors use, are as random as one long stream. The seeds are
 * fixed.
 */
class SensorRandomTest {

    private static final int DRAWS = 100_000;
    private static final long STREAM_KEY = SensorRandom.streamKey(1, "left");

    @Test
    void theSameArgumentsGiveTheSameNumbers() {
        assertEquals(
                SensorRandom.forTick(STREAM_KEY, 7).nextDouble(),
                SensorRandom.forTick(STREAM_KEY, 7).nextDouble());
        assertEquals(
                SensorRandom.forTick(STREAM_KEY, 7).nextGaussian(),
                SensorRandom.forTick(SensorRandom.streamKey(1, "left"), 7).nextGaussian());
    }

    @Test
    void anotherSeedSensorOrTickGivesOthers() {
        double first = SensorRandom.forTick(STREAM_KEY, 7).nextDouble();
        assertNotEquals(first, SensorRandom.forTick(STREAM_KEY, 8).nextDouble());
        assertNotEquals(
                first,
                SensorRandom.forTick(SensorRandom.streamKey(2, "left"), 7).nextDouble());
        assertNotEquals(
                first,
                SensorRandom.forTick(SensorRandom.streamKey(1, "right"), 7).nextDouble());
    }

    @Test
    void uniformNumbersFillAHundredBinsEvenly() {
        int[] bins = new int[100];
        for (int tick = 0; tick < DRAWS; tick++) {
            double u = SensorRandom.forTick(STREAM_KEY, tick).nextDouble();
            assertTrue(u >= 0 && u < 1);
            bins[(int) (100 * u)]++;
        }
        double chiSquare = 0;
        for (int count : bins) {
            double expected = DRAWS / 100.0;
            chiSquare += (count - expected) * (count - expected) / expected;
        }
        // 99 degrees of freedom: 99.9 % of uniform samples lie below 149, and 99.9 % above 61.
        assertTrue(chiSquare > 61 && chiSquare < 149, "chi-square " + chiSquare);
    }

    @Test
    void gaussianNumbersHaveTheMomentsOfTheNormalDistribution() {
        // Four standard errors each: 1, sqrt 2, sqrt 15 and sqrt 96 over the root of the number of draws.
        double error = 4 / Math.sqrt(DRAWS);
        assertEquals(0, mean(SensorRandom::nextGaussian), error);
        assertEquals(1, mean(random -> Math.pow(random.nextGaussian(), 2)), error * Math.sqrt(2));
        assertEquals(0, mean(random -> Math.pow(random.nextGaussian(), 3)), error * Math.sqrt(15));
        assertEquals(3, mean(random -> Math.pow(random.nextGaussian(), 4)), error * Math.sqrt(96));
    }

    @Test
    void neighbouringTicksAndSensorsAreNotCorrelated() {
        double error = 4 / Math.sqrt(DRAWS);
        long other = SensorRandom.streamKey(1, "right");
        double ticks = 0;
        double sensors = 0;
        for (int tick = 0; tick < DRAWS; tick++) {
            double here = SensorRandom.forTick(STREAM_KEY, tick).nextGaussian();
            ticks += here * SensorRandom.forTick(STREAM_KEY, tick + 1).nextGaussian();
            sensors += here * SensorRandom.forTick(other, tick).nextGaussian();
        }
        assertEquals(0, ticks / DRAWS, error);
        assertEquals(0, sensors / DRAWS, error);
    }

    private static double mean(ToDoubleFunction<SensorRandom> draw) {
        double sum = 0;
        for (int tick = 0; tick < DRAWS; tick++) {
            sum += draw.applyAsDouble(SensorRandom.forTick(STREAM_KEY, tick));
        }
        return sum / DRAWS;
    }
}
