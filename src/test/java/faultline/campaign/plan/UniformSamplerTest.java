package faultline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.BitSet;
import java.util.SplittableRandom;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class UniformSamplerTest {

    @Test
    void aDrawDependsOnSeedStreamAndBlockAlone() {
        UniformSampler sampler = new UniformSampler(7, false, 10);
        double third = sampler.uniform("speed", 3);
        sampler.uniform("cone", 1);
        assertEquals(third, sampler.uniform("speed", 3));
        assertEquals(third, new UniformSampler(7, false, 99).uniform("speed", 3));
        assertNotEquals(third, sampler.uniform("speed", 4));
        assertNotEquals(third, sampler.uniform("cone", 3));
        assertNotEquals(third, new UniformSampler(8, false, 10).uniform("speed", 3));
    }

    /** Returns what SplitMix64 makes of a state; the JDK adds this number to the state first. */
    private static long mix(long state) {
        return new SplittableRandom(state - 0x9E3779B97F4A7C15L).nextLong();
    }

    /** Returns the state that belongs to seed 7 and a stream. */
    private static long key(String stream) {
        long key = new SplittableRandom(7).nextLong();
        for (char c : stream.toCharArray()) {
            key = new SplittableRandom(key + c).nextLong();
        }
        return key;
    }

    /** The parts of a campaign, and a campaign and its repetition, may be made by different versions. */
    @Test
    void theDrawsAreThoseOfEarlierVersions() {
        for (int block = 0; block < 5; block++) {
            long bits = mix(key("speed") ^ mix(block * 0x9E3779B97F4A7C15L + 1));
            double expected = (bits >>> 11) * 0x1.0p-53;
            assertEquals(expected, new UniformSampler(7, false, 5).uniform("speed", block));
            double latin = new UniformSampler(7, true, 5).uniform("speed", block);
            assertEquals((order()[block] + expected) / 5, latin, 1e-15);
        }
    }

    /** Returns the parts of five blocks, each inserted at a random place. */
    private static int[] order() {
        SplittableRandom random = new SplittableRandom(mix(key("speed") + 1));
        int[] order = new int[5];
        for (int i = 0; i < 5; i++) {
            int place = (int) ((random.nextLong() >>> 11) * 0x1.0p-53 * (i + 1));
            order[i] = order[place];
            order[place] = i;
        }
        return order;
    }

    /** Larger numbers of blocks have no table of their order. */
    @ParameterizedTest
    @ValueSource(ints = {1, 1000, UniformSampler.MAX_TABLE + 1, 1 << 20, 1_300_000})
    void aLatinHypercubeHitsEachOfItsPartsOnce(int blocks) {
        UniformSampler sampler = new UniformSampler(1, true, blocks);
        for (String stream : new String[] {"speed", "cone"}) {
            BitSet hit = new BitSet();
            IntStream.range(0, blocks).forEach(block -> hit.set((int) (sampler.uniform(stream, block) * blocks)));
            assertEquals(blocks, hit.cardinality(), stream);
        }
    }

    /** The place in its part has a mean of 1/2 and a variance of 1/12, whose standard errors are 0.009 and 0.002. */
    @Test
    void aDrawOfALatinHypercubeIsAnywhereInItsPart() {
        int blocks = 1000;
        UniformSampler sampler = new UniformSampler(1, true, blocks);
        double[] places = IntStream.range(0, blocks)
                .mapToDouble(block -> sampler.uniform("speed", block) * blocks % 1)
                .toArray();
        double mean = Arrays.stream(places).average().orElseThrow();
        double variance = Arrays.stream(places)
                .map(place -> (place - mean) * (place - mean))
                .average()
                .orElseThrow();
        assertEquals(0.5, mean, 0.04);
        assertEquals(1.0 / 12, variance, 0.01);
    }

    /** The standard error of a correlation of independent draws is 1/100 and 1/1000. */
    @ParameterizedTest
    @ValueSource(ints = {10_000, UniformSampler.MAX_TABLE + 1})
    void twoStreamsOfALatinHypercubeAreUncorrelated(int blocks) {
        UniformSampler sampler = new UniformSampler(1, true, blocks);
        for (int shift = 0; shift < 3; shift++) {
            int later = shift;
            double withOther = correlation(sampler, blocks, i -> sampler.uniform("b", (i + later) % blocks));
            assertTrue(Math.abs(withOther) < 3 / Math.sqrt(blocks), "correlation " + withOther);
            double withLater = correlation(sampler, blocks, i -> sampler.uniform("a", (i + later + 1) % blocks));
            assertTrue(Math.abs(withLater) < 3 / Math.sqrt(blocks), "correlation " + withLater);
        }
    }

    /** Returns the correlation of a stream with other numbers that have the same distribution. */
    private static double correlation(UniformSampler sampler, int blocks, IntToDoubleFunction other) {
        return IntStream.range(0, blocks)
                .mapToDouble(i -> (sampler.uniform("a", i) - 0.5) * (other.applyAsDouble(i) - 0.5))
                .map(product -> 12 * product / blocks)
                .sum();
    }

    /** Tables of their orders would need 40 GB. */
    @Test
    void theDrawsOfTheLargestPlanNeedNoMemory() {
        int blocks = (int) CampaignPlan.MAX_RUNS;
        UniformSampler sampler = new UniformSampler(1, true, blocks);
        double[] draws = IntStream.range(0, 1000)
                .mapToDouble(i -> sampler.uniform("stream " + i, blocks - 1))
                .toArray();
        assertEquals(0.5, Arrays.stream(draws).average().orElseThrow(), 0.04);
        assertEquals(1000, Arrays.stream(draws).distinct().count());
    }

    /** This draw is less than 1e-9 of its part below the end of the last part, so that the quotient rounds to 1. */
    @Test
    void aDrawAtTheEndOfTheLastPartOfTheLargestPlanIsBelowOne() {
        UniformSampler sampler = new UniformSampler(584_312_885, true, (int) CampaignPlan.MAX_RUNS);
        assertEquals(Math.nextDown(1.0), sampler.uniform("a", 2_674_281));
    }
}
