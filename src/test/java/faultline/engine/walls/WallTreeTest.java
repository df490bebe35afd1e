package faultline.engine.walls;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.SpatialIndex;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Searches in the tree of walls find what comparing all walls finds, in few steps. */
class WallTreeTest {

    private static final double WANTED = 0.35;

    private static WorldSpec world(int count, Function<Integer, Obstacle> obstacle) {
        return new WorldSpec(
                6,
                4,
                true,
                3,
                IntStream.range(0, count).mapToObj(obstacle::apply).toList());
    }

    private static Obstacle circle(int i, double x, double y, double radius) {
        return new Obstacle("c" + i, new ObstacleShape.CircleShape(radius), new Pose(x, y, 0));
    }

    /** Poles, each several times, among those with the same centre and others. */
    private static WorldSpec crowd(Random random) {
        return world(200, i -> {
            int place = random.nextInt(5);
            return circle(i, 1 + place, 1 + place % 2, 0.01 * (1 + random.nextInt(i % 2 == 0 ? 2 : 30)));
        });
    }

    private static List<Integer> within(SpatialIndex walls, Vector2 point, double radius) {
        return IntStream.range(0, walls.size())
                .filter(i -> walls.shape(i).distanceTo(point.x(), point.y()) <= radius)
                .boxed()
                .toList();
    }

    @Test
    void aWallIsFoundExactlyIfOneIsWithinTheRadius() {
        Random random = new Random(21);
        for (int round = 0; round < 60; round++) {
            WallReference walls = new WallReference(
                    round % 3 == 0
                            ? crowd(random)
                            : round % 3 == 1 ? CoverageTest.staircases(random) : CoverageTest.clutter(random));
            for (int i = 0; i < 50; i++) {
                Vector2 point = new Vector2(8 * random.nextDouble(), 6 * random.nextDouble());
                double radius = random.nextDouble();
                WallTree tree = walls.tree();
                int found = tree.find(point, radius, k -> tree.wall(k).distanceTo(point.x(), point.y()) <= radius);
                assertEquals(
                        within(walls.walls(), point, radius).isEmpty(), found == WallTree.NONE, round + ": " + point);
            }
        }
    }

    @Test
    void allWallsWithinTheRadiusAreTakenOnce() {
        Random random = new Random(22);
        for (int round = 0; round < 60; round++) {
            WallReference walls = new WallReference(round % 2 == 0 ? crowd(random) : CoverageTest.clutter(random));
            WallTree.Untaken untaken = walls.tree().new Untaken();
            List<Integer> taken = new ArrayList<>();
            for (int i = 0; i < 20; i++) {
                Vector2 point = new Vector2(8 * random.nextDouble(), 6 * random.nextDouble());
                double radius = random.nextDouble();
                List<Integer> expected = new ArrayList<>(within(walls.walls(), point, radius));
                expected.removeAll(taken);
                List<Integer> found = untaken.take(point, radius);
                assertEquals(expected, found.stream().sorted().toList());
                taken.addAll(found);
            }
        }
    }

    @Test
    void onlyAWallThatStandsForOthersHasEqualOnes() {
        WallReference walls = new WallReference(world(9, i -> circle(i, 2, 2, i < 8 ? 0.1 : 0.2)));
        WallTree tree = walls.tree();
        List<Boolean> equal = new ArrayList<>();
        tree.find(new Vector2(2, 2), 0.05, i -> {
            boolean isPole = tree.wall(i).boundingRadius() < 1;
            return isPole && !equal.add(tree.hasEqual(i));
        });
        assertEquals(
                List.of(true, false),
                equal.stream().sorted((a, b) -> Boolean.compare(b, a)).toList());
    }

    /** Returns the steps in which the places along all walls are found, and those that a share of a passage needs. */
    private static long steps(WorldSpec world) {
        WallReference walls = new WallReference(world);
        List<WallReference.WallSample> places = walls.samplesAlongPath(WANTED, 0.02);
        Coverage coverage = new Coverage(walls, WANTED);
        places.forEach(place -> coverage.visit(place.position()));
        assertTrue(coverage.share().orElseThrow() > 0.9);
        return walls.tree().steps();
    }

    private static WorldSpec poles(int count) {
        Random random = new Random(1);
        return world(count, i -> circle(i, 2.5 + random.nextDouble(), 0.05 + 0.2 * random.nextDouble(), 0.005));
    }

    private static WorldSpec circlesInOnePlace(int count) {
        return world(count, i -> circle(i, 3, 0.15, 0.1));
    }

    private static WorldSpec tablesInOnePlace(int count) {
        return world(count, i -> new Obstacle("t" + i, new ObstacleShape.RectangleShape(1, 0.25), new Pose(3, 2, 0.3)));
    }

    /** Comparing each place with all walls near it would take about sixteen times as many steps. */
    @Test
    void fourTimesAsManyWallsInOnePlaceTakeAboutFourTimesAsManySteps() {
        for (Function<Integer, WorldSpec> dense : List.<Function<Integer, WorldSpec>>of(
                WallTreeTest::poles, WallTreeTest::circlesInOnePlace, WallTreeTest::tablesInOnePlace)) {
            long few = steps(dense.apply(100));
            long many = steps(dense.apply(400));
            assertTrue(many < 6 * few, many + " instead of " + few + " steps");
        }
    }
}
