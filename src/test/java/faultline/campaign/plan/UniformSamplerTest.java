package faultline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.BitSet;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

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

    @Test
    void aLatinHypercubeHitsEachOfItsPartsOnce() {
        int blocks = 1000;
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

    @Test
    void twoStreamsOfALatinHypercubeAreUncorrelated() {
        int blocks = 10_000;
        UniformSampler sampler = new UniformSampler(1, true, blocks);
        double sum = IntStream.range(0, blocks)
                .mapToDouble(i -> (sampler.uniform("a", i) - 0.5) * (sampler.uniform("b", i) - 0.5))
                .sum();
        assertTrue(Math.abs(12 * sum / blocks) < 0.03, "correlation " + 12 * sum / blocks);
    }
}
