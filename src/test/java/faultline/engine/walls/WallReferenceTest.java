package faultline.engine.walls;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.CpuTime;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A square room of 4 m, to be followed with the centre 0.35 m from the wall, and things in it. */
class WallReferenceTest {

    private static final double WANTED = 0.35;

    private static WallReference room(Obstacle... obstacles) {
        return new WallReference(new WorldSpec(4, 4, true, 3, List.of(obstacles)));
    }

    private static Obstacle inTheMiddle(ObstacleShape shape) {
        return new Obstacle("thing", shape, new Pose(2, 2, 0));
    }

    @Test
    void inASquareRoomTheCornersCannotBePassed() {
        double inside = room().samples(WANTED, 0.01, 0).stream()
                .filter(place -> outsideBox(place.position(), 2) == 0)
                .mapToDouble(WallReference.WallSample::wallLength)
                .sum();
        assertEquals(4 * 3.3, inside, 0.05, "0.35 m less at either end of each side");
    }

    @Test
    void everySampleIsAtTheDistanceFromItsWallAndNoNearerToAnyOther() {
        for (WallReference.WallSample place :
                room(inTheMiddle(new ObstacleShape.RectangleShape(0.6, 0.6))).samples(WANTED, 0.01, 0)) {
            Vector2 at = place.position();
            double enclosure = outsideBox(at, 2) > 0
                    ? outsideBox(at, 2)
                    : Math.min(2 - Math.abs(at.x() - 2), 2 - Math.abs(at.y() - 2));
            assertEquals(WANTED, Math.min(enclosure, outsideBox(at, 0.3)), 1e-6);
        }
    }

    /** How far a point is outside a square about the middle, metres; 0 inside. */
    private static double outsideBox(Vector2 at, double half) {
        return Math.hypot(Math.max(0, Math.abs(at.x() - 2) - half), Math.max(0, Math.abs(at.y() - 2) - half));
    }

    @Test
    void aRoundObstacleCanBePassedAllAround() {
        double around = room(inTheMiddle(new ObstacleShape.CircleShape(0.5))).samples(WANTED, 0.01, 0).stream()
                .filter(place -> place.position().distanceTo(new Vector2(2, 2)) < 0.9)
                .mapToDouble(WallReference.WallSample::wallLength)
                .sum();
        assertEquals(Math.PI, around, 0.001, "its circumference");
    }

    @Test
    void aThinPartitionHasTwoSidesAndTwoEndsWithoutLength() {
        Obstacle partition =
                inTheMiddle(new ObstacleShape.WallShape(List.of(new Vector2(0, -0.5), new Vector2(0, 0.5))));
        List<WallReference.WallSample> around = room(partition).samples(WANTED, 0.01, 0).stream()
                .filter(place -> place.position().distanceTo(new Vector2(2, 2)) < 0.9)
                .toList();
        assertEquals(
                2,
                around.stream()
                        .mapToDouble(WallReference.WallSample::wallLength)
                        .sum(),
                1e-9);
        assertTrue(
                around.stream()
                        .anyMatch(place ->
                                place.wallLength() == 0 && place.position().y() > 2.84),
                "places above its upper end");
    }

    @Test
    void aMovingObstacleIsNoWall() {
        WaypointPath motion = new WaypointPath(0.1, true, List.of(new Vector2(1, 1)));
        Obstacle visitor = new Obstacle("visitor", new ObstacleShape.CircleShape(0.3), new Pose(2, 2, 0), motion);
        assertEquals(room().samples(WANTED, 0.01, 0), room(visitor).samples(WANTED, 0.01, 0));
    }

    /** A path of 31 million places did not fit into memory. */
    @ParameterizedTest
    @CsvSource({"4, 100000", "100000, 0.35"})
    void aPathThatIsTooLongIsRefusedSoon(double size, double distance) {
        WallReference walls = new WallReference(new WorldSpec(size, size, true, 3, List.of()));
        CpuTime time = CpuTime.start();
        Exception refusal =
                assertThrows(WallReference.PathTooLongException.class, () -> walls.samplesAlongPath(distance, 0.02));
        assertEquals(
                "the path at a distance of " + DecimalText.format(distance)
                        + " m from the walls has too many places; expected at most 2000000",
                refusal.getMessage());
        time.assertBelow(10);
    }

    /**
     * 2000 parallel walls of 10 m lie within 0.2 m of each other. Only the first and the last have free places along
     * them, 33 333 each. The others have more than 2 million blocks of 64 places that are all occupied.
     */
    @Test
    void occupiedPlacesDoNotMakeAPathTooLong() {
        List<Vector2> line = List.of(new Vector2(-5, 0), new Vector2(5, 0));
        List<Obstacle> walls = IntStream.range(0, 2000)
                .mapToObj(i -> new Obstacle("w" + i, new ObstacleShape.WallShape(line), new Pose(6, 1 + 1e-4 * i, 0)))
                .toList();
        WallReference pile = new WallReference(new WorldSpec(12, 3, false, 3, walls));
        List<WallReference.WallSample> places = pile.samples(WANTED, 0.0003, 0);
        double along = places.stream()
                .mapToDouble(WallReference.WallSample::wallLength)
                .sum();
        assertEquals(2 * 10, along, 1e-3);
    }

    @Test
    void aWorldWithoutWallsHasNoPathAtAnyDistance() {
        WallReference open = new WallReference(new WorldSpec(4, 4, false, 3, List.of()));
        assertEquals(List.of(), open.samplesAlongPath(100_000, 0.02));
    }
}
