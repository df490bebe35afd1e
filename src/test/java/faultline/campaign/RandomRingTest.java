package faultline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vector2;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class RandomRingTest {

    private static boolean isRectilinear(List<Vector2> ring) {
        return IntStream.range(0, ring.size()).allMatch(i -> {
            Vector2 wall = ring.get((i + 1) % ring.size()).minus(ring.get(i));
            return Math.min(Math.abs(wall.x()), Math.abs(wall.y())) < 1e-9;
        });
    }

    @Test
    void ringsHave4To9WallsAndThoseOfRightAnglesAreRectangles() {
        Map<Integer, Integer> rings = new TreeMap<>();
        int rectangles = 0;
        for (long seed = 0; seed < 4000; seed++) {
            List<Vector2> ring = RandomRing.next(new SplittableRandom(seed), StrictMath.toRadians(60));
            rings.merge(ring.size(), 1, Integer::sum);
            if (isRectilinear(ring)) {
                assertEquals(4, ring.size(), "seed " + seed);
                rectangles++;
            }
        }
        assertEquals(Set.of(4, 5, 6, 7, 8, 9), rings.keySet(), rings::toString);
        assertTrue(rectangles > 400, rectangles + " rectangles");
    }
}
