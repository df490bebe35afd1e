package faultline.engine.walls;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.ConvexShape;
import faultline.geometry.Pose;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.SpatialIndex;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** A square room of 4 m, in which walls are found up to 0.7 m away. */
class NearestWallTest {

    private static final double RANGE = 0.7;
    private static final Vector2 NOWHERE = new Vector2(Double.POSITIVE_INFINITY, 0);
    private static final double MARGIN = 0.5;

    private static NearestWall.Wall nearest(double x, double y, Obstacle... obstacles) {
        SpatialIndex walls = SpatialIndex.ofStaticShapes(new WorldSpec(4, 4, true, 3, List.of(obstacles)));
        return new NearestWall(walls, RANGE).of(new Vector2(x, y), MARGIN);
    }

    @Test
    void theNearestOfSeveralWallsCounts() {
        assertEquals(0.4, nearest(1, 0.4).distance(), 1e-12);
        assertEquals(0.3, nearest(3.7, 2).distance(), 1e-12);
    }

    @Test
    void nearACornerAWallIsNotStraight() {
        assertFalse(nearest(0.49, 0.3).straight());
        assertTrue(nearest(0.51, 0.3).straight());
    }

    @Test
    void wallsBeyondTheRangeAreIgnored() {
        assertEquals(0.7, nearest(2, 0.7).distance(), 1e-12);
        assertEquals(new NearestWall.Wall(Double.POSITIVE_INFINITY, NOWHERE, false), nearest(2, 0.71));
    }

    @Test
    void aCurvedObstacleIsNotStraight() {
        Obstacle pillar = new Obstacle("pillar", new ObstacleShape.CircleShape(0.5), new Pose(2, 2, 0));
        NearestWall.Wall wall = nearest(2, 1.2, pillar);
        assertEquals(0.3, wall.distance(), 1e-12);
        assertFalse(wall.straight());
    }

    /** On the diagonal of a corner, both of its walls are equally near. */
    @Test
    void ofTwoWallsTheFirstInTheWorldCountsWhicheverWasNearerBefore() {
        SpatialIndex walls = SpatialIndex.ofStaticShapes(new WorldSpec(4, 4, true, 3, List.of()));
        Vector2 diagonal = new Vector2(0.3, 0.3);
        NearestWall.Wall first = bruteForce(walls, RANGE, diagonal);
        for (Vector2 before : List.of(new Vector2(0.29, 0.3), new Vector2(0.3, 0.29))) {
            NearestWall along = new NearestWall(walls, RANGE);
            assertEquals(0.29, along.of(before, MARGIN).distance(), 1e-12);
            assertEquals(first, along.of(diagonal, MARGIN));
        }
    }

    @Test
    void alongAPathEveryWallIsTheOneThatBruteForceFinds() {
        Random random = new Random(815);
        int found = 0;
        for (int i = 0; i < 60; i++) {
            WorldSpec world = i % 2 == 0 ? CoverageTest.staircases(random) : CoverageTest.clutter(random);
            SpatialIndex walls = SpatialIndex.ofStaticShapes(world);
            double range = List.of(0.024, 0.4, 0.7, 3.0).get(random.nextInt(4));
            NearestWall along = new NearestWall(walls, range);
            Vector2 point = new Vector2(8 * random.nextDouble(), 6 * random.nextDouble());
            for (int step = 0; step < 2000; step++) {
                NearestWall.Wall expected = bruteForce(walls, range, point);
                assertEquals(expected, along.of(point, MARGIN), "world " + i + ", step " + step + ", at " + point);
                found += expected.distance() <= range ? 1 : 0;
                point = next(point, random);
            }
        }
        assertTrue(found > 50_000, found + " walls");
    }

    /** Returns a point a little farther on the path, at times on a raster or far away. */
    private static Vector2 next(Vector2 point, Random random) {
        return switch (random.nextInt(100)) {
            case 0 -> new Vector2(8 * random.nextDouble(), 6 * random.nextDouble());
            case 1 -> new Vector2(0.05 * Math.rint(20 * point.x()), 0.05 * Math.rint(20 * point.y()));
            default ->
                point.plus(Vector2.direction(2 * Math.PI * random.nextDouble()).times(0.01));
        };
    }

    private static NearestWall.Wall bruteForce(SpatialIndex walls, double range, Vector2 point) {
        double least = Double.POSITIVE_INFINITY;
        Vector2 nearest = NOWHERE;
        boolean straight = false;
        for (int i = 0; i < walls.size(); i++) {
            ConvexShape wall = walls.shape(i);
            Vector2 foot = wall.nearestTo(point);
            double distance = foot.distanceTo(point);
            if (distance <= range && distance < least) {
                least = distance;
                nearest = foot;
                straight = wall instanceof Segment segment
                        && foot.distanceTo(segment.a()) >= MARGIN
                        && foot.distanceTo(segment.b()) >= MARGIN;
            }
        }
        return new NearestWall.Wall(least, nearest, straight);
    }
}
