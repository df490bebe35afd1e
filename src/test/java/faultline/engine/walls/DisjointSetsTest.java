package faultline.engine.walls;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class DisjointSetsTest {

    /** Brute force gives each number the least one of its set. */
    @Test
    void joinedNumbersHaveTheSameLeastNumber() {
        Random random = new Random(57);
        for (int trial = 0; trial < 200; trial++) {
            int count = 1 + random.nextInt(30);
            DisjointSets sets = new DisjointSets(count);
            int[] expected = IntStream.range(0, count).toArray();
            for (int joined = random.nextInt(count); joined > 0; joined--) {
                int one = random.nextInt(count);
                int other = random.nextInt(count);
                sets.join(one, other);
                int a = expected[one];
                int b = expected[other];
                expected = Arrays.stream(expected)
                        .map(least -> least == a || least == b ? Math.min(a, b) : least)
                        .toArray();
            }
            assertEquals(
                    Arrays.toString(expected),
                    Arrays.toString(IntStream.range(0, count).map(sets::least).toArray()));
        }
    }
}
