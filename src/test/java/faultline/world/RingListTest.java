package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.geometry.Pose;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import faultline.world.ObstacleShape.PlanShape;
import faultline.world.ObstacleShape.PolygonShape;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;

/** A plan is the same as its rings as polygons. */
class RingListTest {

    private static List<List<Vector2>> randomRings(SplittableRandom random) {
        List<List<Vector2>> rings = new ArrayList<>();
        for (int ring = random.nextInt(1, 6); ring > 0; ring--) {
            List<Vector2> points = new ArrayList<>();
            for (int i = random.nextInt(3, 9); i > 0; i--) {
                points.add(new Vector2(random.nextInt(-4, 5) * 0.5, random.nextInt(-4, 5) * 0.5));
            }
            rings.add(points);
        }
        return rings;
    }

    @Test
    void itIsInsideAnOddNumberOfItsRings() {
        SplittableRandom random = new SplittableRandom(71);
        for (int trial = 0; trial < 2000; trial++) {
            List<List<Vector2>> rings = randomRings(random);
            PlanShape plan = new PlanShape(rings);
            Vector2 point = new Vector2(random.nextInt(-5, 6) * 0.5, random.nextDouble(-3, 3));
            long around = rings.stream()
                    .filter(ring -> new PolygonShape(ring).contains(point))
                    .count();
            assertEquals(around % 2 == 1, plan.contains(point), "trial " + trial);
            double reach = rings.stream()
                    .mapToDouble(ring -> new PolygonShape(ring).boundingRadius())
                    .max()
                    .orElseThrow();
            assertEquals(reach, plan.boundingRadius());
        }
    }

    /** Half of the numbers are multiples of 0.5, so that points are on sides, on corners, and level with them. */
    private static double coordinate(SplittableRandom random) {
        return random.nextBoolean() ? random.nextInt(-5, 6) * 0.5 : random.nextDouble(-3, 3);
    }

    @Test
    void nearAPointItIsInsideWhereTheWholeIs() {
        SplittableRandom random = new SplittableRandom(73);
        int inside = 0;
        for (int trial = 0; trial < 5000; trial++) {
            RingList rings = RingList.copyOf(randomRings(random));
            Vector2 centre = new Vector2(coordinate(random), coordinate(random));
            double reach = random.nextInt(4) == 0 ? 0.5 * random.nextInt(4) : random.nextDouble(2);
            RingList.Neighbourhood near = rings.around(centre, reach);
            for (int i = 0; i < 40; i++) {
                double x = centre.x() + Math.max(-reach, Math.min(reach, coordinate(random)));
                double y = centre.y() + Math.max(-reach, Math.min(reach, coordinate(random)));
                assertEquals(rings.contains(x, y), near.contains(x, y), "trial " + trial + " at " + x + ", " + y);
                inside += near.contains(x, y) ? 1 : 0;
            }
        }
        assertEquals(100_000, inside, 80_000);
    }

    @Test
    void itsSidesAreThoseOfItsRingsInTheirOrder() {
        SplittableRandom random = new SplittableRandom(72);
        for (int trial = 0; trial < 200; trial++) {
            List<List<Vector2>> rings = randomRings(random);
            Pose pose = new Pose(random.nextDouble(-9, 9), random.nextDouble(-9, 9), random.nextDouble(7));
            Obstacle plan = new Obstacle("plan", new PlanShape(rings), pose);
            List<Object> expected = new ArrayList<>();
            rings.forEach(
                    ring -> expected.addAll(ObstacleGeometry.of(new Obstacle("ring", new PolygonShape(ring), pose))
                            .parts()));
            assertEquals(expected, ObstacleGeometry.of(plan).parts());

            Vector2 point = new Vector2(pose.x() + random.nextDouble(-3, 3), pose.y() + random.nextDouble(-3, 3));
            double distance = random.nextDouble(0.1, 2);
            Set<Object> near =
                    new HashSet<>(ObstacleGeometry.near(plan, point, distance).parts());
            for (Object side : expected) {
                boolean reaches = ((Segment) side).distanceTo(point.x(), point.y()) <= distance;
                assertEquals(true, !reaches || near.contains(side), "trial " + trial);
            }
        }
    }

    @Test
    void itIsEqualToTheListOfItsRings() {
        List<List<Vector2>> rings = randomRings(new SplittableRandom(73));
        PlanShape plan = new PlanShape(rings);
        assertEquals(rings, plan.rings());
        assertEquals(new PlanShape(rings), plan);
        assertEquals(new PlanShape(rings).hashCode(), plan.hashCode());
        assertSame(plan.rings(), new PlanShape(plan.rings()).rings());
        assertThrows(UnsupportedOperationException.class, () -> plan.rings().remove(0));
        assertThrows(
                UnsupportedOperationException.class, () -> plan.rings().get(0).set(0, Vector2.ZERO));
        assertThrows(IndexOutOfBoundsException.class, () -> plan.rings().get(0).get(-1));
    }

    @Test
    void ringsThatEncloseNothingAreRefused() {
        List<Vector2> two = List.of(Vector2.ZERO, new Vector2(1, 0));
        assertThrows(IllegalArgumentException.class, () -> new PlanShape(List.of()));
        assertThrows(IllegalArgumentException.class, () -> new PlanShape(List.of(two)));
        for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY}) {
            List<Vector2> ring = List.of(Vector2.ZERO, new Vector2(1, 0), new Vector2(0, bad));
            assertThrows(IllegalArgumentException.class, () -> new PlanShape(List.of(ring)));
        }
    }

    @Test
    void aPlanOfCoordinatesIsThatOfItsPoints() {
        SplittableRandom random = new SplittableRandom(74);
        for (int trial = 0; trial < 200; trial++) {
            List<List<Vector2>> rings = randomRings(random);
            double[] xs = coordinates(rings, Vector2::x);
            double[] ys = coordinates(rings, Vector2::y);
            PlanShape plan = PlanShape.of(xs, ys, starts(rings));
            assertEquals(new PlanShape(rings), plan);
            assertEquals(xs.length, plan.pointCount());
        }
    }

    private static double[] coordinates(List<List<Vector2>> rings, ToDoubleFunction<Vector2> coordinate) {
        return rings.stream().flatMap(List::stream).mapToDouble(coordinate).toArray();
    }

    private static int[] starts(List<List<Vector2>> rings) {
        int[] starts = new int[rings.size() + 1];
        for (int i = 0; i < rings.size(); i++) {
            starts[i + 1] = starts[i] + rings.get(i).size();
        }
        return starts;
    }

    @Test
    void aPlanOfCoordinatesKeepsNoArrayOfItsCaller() {
        double[] xs = {0, 1, 0, 4, 5, 4};
        double[] ys = {0, 0, 1, 4, 4, 5};
        int[] starts = {0, 3, 6};
        PlanShape plan = PlanShape.of(xs, ys, starts);
        PlanShape same = PlanShape.of(xs, ys, starts);
        xs[0] = 9;
        ys[1] = 9;
        starts[1] = 9;
        assertEquals(same.rings(), plan.rings());
        assertEquals(new Vector2(0, 0), plan.rings().get(0).get(0));
        assertEquals(new Vector2(4, 4), plan.rings().get(1).get(0));
    }

    @Test
    void coordinatesThatAreNoRingsAreRefused() {
        double[] six = {0, 1, 0, 4, 5, 4};
        int[][] wrong = {{}, {0}, {0, 3}, {0, 3, 5}, {0, 3, 7}, {1, 6}, {0, 2, 6}, {0, 4, 6}, {0, 3, 3, 6}, {0, 9, 6}};
        for (int[] starts : wrong) {
            assertThrows(IllegalArgumentException.class, () -> PlanShape.of(six, six, starts), Arrays.toString(starts));
        }
        double[] five = {0, 1, 0, 4, 5};
        assertThrows(IllegalArgumentException.class, () -> PlanShape.of(six, five, new int[] {0, 6}));
        assertThrows(IllegalArgumentException.class, () -> PlanShape.of(five, six, new int[] {0, 5}));
        double[] infinite = {0, 1, 0, 4, Double.POSITIVE_INFINITY, 4};
        assertThrows(IllegalArgumentException.class, () -> PlanShape.of(six, infinite, new int[] {0, 6}));
    }
}
