package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.CpuTime;
import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class DistinctPointsTest {

    private static List<Vector2> byBruteForce(List<Vector2> points) {
        List<Vector2> distinct = new ArrayList<>();
        for (Vector2 point : points) {
            if (distinct.stream().noneMatch(other -> other.distanceTo(point) < 1e-8)) {
                distinct.add(point);
            }
        }
        return distinct;
    }

    private static List<Vector2> distinct(List<Vector2> points) {
        MotionStep.DistinctPoints distinct = new MotionStep.DistinctPoints();
        points.forEach(distinct::add);
        return distinct.points();
    }

    @Test
    void pointsNearEarlierOnesAreLeftOut() {
        SplittableRandom random = new SplittableRandom(66);
        for (int i = 0; i < 300; i++) {
            double size = StrictMath.pow(10, random.nextDouble(-9, -6));
            Vector2 middle = new Vector2(random.nextInt(-3, 4) * 500.0, random.nextInt(-3, 4) * 2e-8);
            List<Vector2> points = new ArrayList<>();
            for (int k = 0; k < 200; k++) {
                points.add(middle.plus(new Vector2(random.nextDouble(-size, size), random.nextDouble(-size, size))));
            }
            assertEquals(byBruteForce(points), distinct(points), "size " + size);
        }
    }

    @Test
    void manyPointsOfALongContactNeedTimeInProportionToTheirNumber() {
        List<Vector2> points = new ArrayList<>();
        for (int i = 0; i < 200_000; i++) {
            points.add(new Vector2(2, 0.9 + 2e-6 * (i / 2)));
        }
        CpuTime time = CpuTime.start();
        assertEquals(100_000, distinct(points).size());
        time.assertBelow(2);
    }
}
