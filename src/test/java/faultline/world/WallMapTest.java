package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** A square room of 4 m, to be followed with the centre 0.35 m from the wall, and things in it. */
class WallMapTest {

    private static final double WANTED = 0.35;
    private static final double MARGIN = 0.5;

    private static WallMap room(Obstacle... obstacles) {
        return new WallMap(new WorldSpec(4, 4, true, 3, List.of(obstacles)));
    }

    private static Obstacle inTheMiddle(ObstacleShape shape) {
        return new Obstacle("thing", shape, new Pose(2, 2, 0));
    }

    @Test
    void anErrorIsHowMuchTooFarTheWallIs() {
        assertEquals(0.05, room().errorOnStraight(new Vec(1, 0.4), WANTED, MARGIN), 1e-12);
        assertEquals(-0.05, room().errorOnStraight(new Vec(3.7, 2), WANTED, MARGIN), 1e-12);
    }

    @Test
    void nearACornerThereIsNoError() {
        assertTrue(Double.isNaN(room().errorOnStraight(new Vec(0.49, 0.3), WANTED, MARGIN)));
        assertEquals(-0.05, room().errorOnStraight(new Vec(0.51, 0.3), WANTED, MARGIN), 1e-12);
    }

    @Test
    void inTheOpenThereIsNoError() {
        assertEquals(0.35, room().errorOnStraight(new Vec(2, 0.7), WANTED, MARGIN), 1e-12);
        assertTrue(Double.isNaN(room().errorOnStraight(new Vec(2, 0.71), WANTED, MARGIN)), "more than twice the wanted distance");
    }

    @Test
    void besideAThingThatIsNotStraightThereIsNoError() {
        assertTrue(Double.isNaN(room(inTheMiddle(new ObstacleShape.Circle(0.5))).errorOnStraight(new Vec(2, 1.2), WANTED, MARGIN)));
    }

    @Test
    void inASquareRoomTheCornersCannotBePassed() {
        double inside = room().places(WANTED, 0.01).stream().filter(place -> outsideBox(place.at(), 2) == 0).mapToDouble(WallMap.Place::length).sum();
        assertEquals(4 * 3.3, inside, 0.05, "0.35 m less at either end of each side");
    }

    @Test
    void everyPlaceIsAtTheDistanceFromTheWallAndNowhereNearerToAny() {
        for (WallMap.Place place : room(inTheMiddle(new ObstacleShape.Rectangle(0.6, 0.6))).places(WANTED, 0.01)) {
            Vec at = place.at();
            double enclosure = outsideBox(at, 2) > 0 ? outsideBox(at, 2) : Math.min(2 - Math.abs(at.x() - 2), 2 - Math.abs(at.y() - 2));
            assertEquals(WANTED, Math.min(enclosure, outsideBox(at, 0.3)), 1e-6);
        }
    }

    /** How far a point is outside a square about the middle, metres; 0 inside. */
    private static double outsideBox(Vec at, double half) {
        return Math.hypot(Math.max(0, Math.abs(at.x() - 2) - half), Math.max(0, Math.abs(at.y() - 2) - half));
    }

    @Test
    void aRoundThingCanBePassedAllRound() {
        double around = room(inTheMiddle(new ObstacleShape.Circle(0.5))).places(WANTED, 0.01).stream()
                .filter(place -> place.at().distanceTo(new Vec(2, 2)) < 0.9).mapToDouble(WallMap.Place::length).sum();
        assertEquals(Math.PI, around, 0.001, "its circumference");
    }

    @Test
    void aThinPartitionHasTwoSidesAndTwoEndsWithoutLength() {
        Obstacle partition = inTheMiddle(new ObstacleShape.Wall(List.of(new Vec(0, -0.5), new Vec(0, 0.5))));
        List<WallMap.Place> around = room(partition).places(WANTED, 0.01).stream().filter(place ->
                place.at().distanceTo(new Vec(2, 2)) < 0.9).toList();
        assertEquals(2, around.stream().mapToDouble(WallMap.Place::length).sum(), 1e-9);
        assertTrue(around.stream().anyMatch(place -> place.length() == 0 && place.at().y() > 2.84), "places above its upper end");
    }

    @Test
    void aMovingThingIsNoWall() {
        Motion motion = new Motion(0.1, true, List.of(new Vec(1, 1)));
        Obstacle visitor = new Obstacle("visitor", new ObstacleShape.Circle(0.3), new Pose(2, 2, 0), Optional.of(motion));
        assertEquals(room().places(WANTED, 0.01), room(visitor).places(WANTED, 0.01));
    }
}
