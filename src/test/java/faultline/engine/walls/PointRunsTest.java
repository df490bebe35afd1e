package faultline.engine.walls;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Searches for runs of points find those that comparing all points finds. */
class PointRunsTest {

    private static final double RADIUS = 0.04;

    private final PointRuns runs = new PointRuns(RADIUS);
    private final List<Vector2> points = new ArrayList<>();

    private int add(double x, double y) {
        points.add(new Vector2(x, y));
        return runs.add(new Vector2(x, y));
    }

    private Set<Integer> near(Vector2 point) {
        Set<Integer> found = new HashSet<>();
        runs.forEachNear(point, found::add);
        return found;
    }

    @Test
    void aRunIsNearIfOneOfItsPointsIs() {
        Random random = new Random(3);
        List<Integer> runOf = new ArrayList<>();
        for (int i = 0; i < 2000; i++) {
            // Points on a lattice are at exactly the radius, or at the same place.
            boolean onLattice = random.nextBoolean();
            double x = onLattice ? RADIUS * random.nextInt(10) : 0.4 * random.nextDouble();
            double y = onLattice ? RADIUS / 2 * random.nextInt(10) : 0.001 * random.nextDouble();
            runOf.add(add(x, y));
        }
        for (Vector2 point : points) {
            Set<Integer> expected = new HashSet<>();
            for (int i = 0; i < points.size(); i++) {
                if (points.get(i).distanceTo(point) <= RADIUS) {
                    expected.add(runOf.get(i));
                }
            }
            assertEquals(expected, near(point));
        }
    }

    @Test
    void thePointsOfARunAreThoseThatWereAddedToIt() {
        add(1.01, 1);
        add(1.01, 1);
        add(1.011, 1);
        add(1.012, 1);
        List<Integer> all = new ArrayList<>();
        runs.forEachPoint(0, all::add);
        assertEquals(List.of(0, 1, 2), all, "all but the one that is farther than a 32nd of the radius");
        assertEquals(
                List.of(false, true, false),
                all.stream().map(i -> runs.isTwin(i, 0)).toList());
        assertEquals(Set.of(0, 3), near(new Vector2(1.01, 1)));
    }

    @Test
    void aClosedRunIsNotFoundAndTakesNoMorePoints() {
        add(1, 1);
        runs.close(0);
        assertEquals(Set.of(), near(new Vector2(1, 1)));
        assertEquals(1, add(1, 1));
        assertEquals(Set.of(1), near(new Vector2(1, 1)));
    }
}
