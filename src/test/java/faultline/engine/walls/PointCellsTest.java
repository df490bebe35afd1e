package faultline.engine.walls;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vector2;
import java.util.Random;
import org.junit.jupiter.api.Test;

class PointCellsTest {

    private static final double RADIUS = 0.05;

    @Test
    void aPlaceIsNearAPointExactlyIfADistanceIsAtMostTheRadius() {
        Random chance = new Random(5);
        PointCells cells = new PointCells(RADIUS + 1e-9);
        for (int i = 0; i < 200; i++) {
            cells.add(randomPoint(chance));
        }
        for (int i = 0; i < 2000; i++) {
            Vector2 place = randomPoint(chance);
            boolean near = cells.points().stream().anyMatch(point -> point.distanceTo(place) <= RADIUS);
            assertEquals(near, cells.isNear(place, RADIUS), place::toString);
        }
    }

    /** Returns a point of a square around the origin in which a fifth of all places is near 200 points. */
    private static Vector2 randomPoint(Random chance) {
        return new Vector2(chance.nextDouble() * 2.6 - 1.3, chance.nextDouble() * 2.6 - 1.3);
    }

    @Test
    void noPlaceIsNearToPointsThatHaveBeenRemoved() {
        PointCells cells = new PointCells(RADIUS + 1e-9);
        cells.add(new Vector2(1, 2));
        assertTrue(cells.isNear(new Vector2(1, 2.05), RADIUS));
        cells.clear();
        assertFalse(cells.isNear(new Vector2(1, 2), RADIUS));
        assertTrue(cells.points().isEmpty());
    }
}
