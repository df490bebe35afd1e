package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.FollowerState;
import faultline.engine.walls.WallCircuit;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Verdicts in rooms of 6 x 4 m with passages of 0.5 m. At the wanted distance, 0.35 m from the centre, no path leads
 * through them, but the body is only 0.2 m wide. The robot drives 0.5 m/s.
 */
class OtherWallsTest {

    private static final double DISTANCE = 0.35;

    private static CarryOnMetrics metrics(Obstacle... obstacles) {
        return metrics(new WorldSpec(6, 4, true, 3, List.of(obstacles)));
    }

    private static CarryOnMetrics metrics(WorldSpec world) {
        return new CarryOnMetrics(CarryOnMetrics.circuit(world, DISTANCE, RobotSpec.DEFAULT), 0.5, 0);
    }

    private static Obstacle box(String id, double left, double bottom, double right, double top) {
        return new Obstacle(
                id,
                new ObstacleShape.RectangleShape(right - left, top - bottom),
                new Pose((left + right) / 2, (bottom + top) / 2, 0));
    }

    /** Drives once around a rectangle at a time, and back to its corner on the lower left. */
    private static void driveAround(
            CarryOnMetrics metrics, double time, double left, double bottom, double right, double top) {
        List<Vector2> corners = List.of(
                new Vector2(left, bottom),
                new Vector2(right, bottom),
                new Vector2(right, top),
                new Vector2(left, top),
                new Vector2(left, bottom));
        corners.forEach(corner -> metrics.update(time, corner, FollowerState.FOLLOW, false));
    }

    /** The box is 0.5 m from the lower wall, so its path and that of the room are one path of 21.5 m. */
    private static CarryOnMetrics withBox() {
        return metrics(box("box", 2.5, 0.5, 3.5, 1.5));
    }

    /** The time of two laps of 21.5 m, 106 s after the start, is up, and nothing else changes. */
    private static void endTheTimeOfTheFirstWall(CarryOnMetrics metrics) {
        metrics.update(120, new Vector2(3, 3), FollowerState.FOLLOW, false);
    }

    private static void driveAroundBox(CarryOnMetrics metrics, double time) {
        driveAround(metrics, time, 2.15, 0.15, 3.85, 1.85);
    }

    private static void driveAroundRoom(CarryOnMetrics metrics, double time) {
        driveAround(metrics, time, DISTANCE, DISTANCE, 6 - DISTANCE, 4 - DISTANCE);
    }

    @Test
    void aRobotThatPassesAndCirclesTheBoxCarriesOn() {
        CarryOnMetrics metrics = withBox();
        driveAroundBox(metrics, 10);
        driveAroundBox(metrics, 20);
        driveAroundBox(metrics, 30);
        driveAroundBox(metrics, 40);
        driveAroundBox(metrics, 50);
        assertEquals(0.2, metrics.share().orElseThrow(), 0.1);
        assertFalse(metrics.carriedOn(), "only the first wall counts while there is time for it");
        endTheTimeOfTheFirstWall(metrics);
        assertTrue(metrics.carriedOn());
        assertEquals(1, metrics.share().orElseThrow(), 1e-9);
        assertEquals(5, metrics.laps().orElseThrow(), 0.2);
    }

    @Test
    void twoLapsOfTheBoxAreShorterThanFourFifthsOfThePath() {
        CarryOnMetrics metrics = withBox();
        driveAroundBox(metrics, 10);
        driveAroundBox(metrics, 20);
        endTheTimeOfTheFirstWall(metrics);
        assertFalse(metrics.carriedOn());
    }

    @Test
    void aRobotThatPassesAndFollowsTheRoomCarriesOnAsForThePathOfTheRoom() {
        CarryOnMetrics metrics = withBox();
        driveAroundRoom(metrics, 10);
        driveAroundRoom(metrics, 20);
        endTheTimeOfTheFirstWall(metrics);
        assertTrue(metrics.carriedOn());
        assertTrue(metrics.share().orElseThrow() > 0.8);
    }

    @Test
    void aRobotThatCirclesTheBoxTooLateDoesNotCarryOn() {
        CarryOnMetrics metrics = withBox();
        driveAroundBox(metrics, 10);
        driveAroundBox(metrics, 20);
        for (int lap = 0; lap < 4; lap++) {
            driveAroundBox(metrics, 200);
        }
        assertTrue(metrics.isDecided());
        assertFalse(metrics.carriedOn());
    }

    @Test
    void aRobotThatTurnsToAndFroDoesNotCarryOn() {
        CarryOnMetrics metrics = withBox();
        for (int i = 0; i < 20; i++) {
            metrics.update(10, new Vector2(0.35, 0.35), FollowerState.FOLLOW, false);
            metrics.update(10, new Vector2(2, 0.35), FollowerState.FOLLOW, false);
        }
        assertEquals(0.1, metrics.share().orElseThrow(), 0.05);
        endTheTimeOfTheFirstWall(metrics);
        assertFalse(metrics.carriedOn());
    }

    /** Drives around the box once, to the left or to the right. */
    private static void driveAroundPost(CarryOnMetrics metrics, boolean left) {
        for (int degrees = 0; degrees <= 360; degrees += 5) {
            Vector2 way = Vector2.direction(StrictMath.toRadians(left ? degrees : -degrees));
            metrics.update(10, new Vector2(3, 0.55).plus(way.times(0.4)), FollowerState.FOLLOW, false);
        }
    }

    /** The box is 0.1 m wide and 0.5 m from the lower wall. */
    private static CarryOnMetrics withPost() {
        return metrics(box("post", 2.95, 0.5, 3.05, 0.6));
    }

    @Test
    void aRobotThatDrivesToAndFroAroundASmallBoxDoesNotCarryOn() {
        CarryOnMetrics metrics = withPost();
        for (int lap = 0; lap < 20; lap++) {
            driveAroundPost(metrics, lap % 2 == 0);
        }
        endTheTimeOfTheFirstWall(metrics);
        assertFalse(metrics.carriedOn());
    }

    @Test
    void aRobotThatCirclesASmallBoxCarriesOnOnEitherSide() {
        for (boolean left : new boolean[] {true, false}) {
            CarryOnMetrics metrics = withPost();
            for (int lap = 0; lap < 12; lap++) {
                driveAroundPost(metrics, left);
            }
            endTheTimeOfTheFirstWall(metrics);
            assertTrue(metrics.carriedOn());
        }
    }

    @Test
    void aRobotThatCirclesASmallBoxOnceAndLeavesAllWallsDoesNotCarryOn() {
        CarryOnMetrics metrics = withPost();
        driveAroundPost(metrics, true);
        for (int lap = 0; lap < 20; lap++) {
            driveAround(metrics, 20, 2.5, 1.8, 3.5, 2.8);
        }
        endTheTimeOfTheFirstWall(metrics);
        assertFalse(metrics.carriedOn());
    }

    /** It circles the small box once, and then drives along the room: along neither far enough. */
    @Test
    void whatARobotDrivesAlongDifferentWallsIsNotAddedUp() {
        CarryOnMetrics metrics = withPost();
        driveAroundPost(metrics, true);
        for (int i = 0; i < 20; i++) {
            metrics.update(20, new Vector2(0.35, 0.35), FollowerState.FOLLOW, false);
            metrics.update(20, new Vector2(0.35, 3.65), FollowerState.FOLLOW, false);
        }
        endTheTimeOfTheFirstWall(metrics);
        assertFalse(metrics.carriedOn());
    }

    @Test
    void aBoxFarFromTheWallIsAnotherWall() {
        CarryOnMetrics metrics = metrics(box("box", 2.5, 0.8, 3.5, 1.8));
        driveAroundRoom(metrics, 10);
        assertTrue(metrics.carriedOn());
        CarryOnMetrics away = metrics(box("box", 2.5, 0.8, 3.5, 1.8));
        away.update(0, new Vector2(0.35, 0.35), FollowerState.FOLLOW, false);
        for (int i = 0; i < 10; i++) {
            driveAround(away, 10, 2.15, 0.45, 3.85, 2.15);
        }
        endTheTimeOfTheFirstWall(away);
        assertFalse(away.carriedOn());
    }

    /** The box is 0.18 m from the lower wall. */
    @Test
    void aBoxThatTheBodyCannotPassBelongsToTheWall() {
        CarryOnMetrics metrics = metrics(box("box", 2.5, 0.18, 3.5, 1.2));
        for (int i = 0; i < 10; i++) {
            driveAround(metrics, 10, 2.15, 0.1, 3.85, 1.55);
        }
        endTheTimeOfTheFirstWall(metrics);
        assertFalse(metrics.carriedOn());
    }

    /** Two walls divide the room, except for a door of 0.5 m between them. */
    private static CarryOnMetrics withDoor() {
        return metrics(box("lower", 2.4, 0, 2.5, 1.5), box("upper", 2.4, 2, 2.5, 4));
    }

    @Test
    void aRobotThatTurnsBackBeforeADoorCarriesOn() {
        CarryOnMetrics metrics = withDoor();
        driveAround(metrics, 10, DISTANCE, DISTANCE, 2.05, 4 - DISTANCE);
        assertTrue(metrics.carriedOn());
    }

    /** The path of this side is 10 m long, so that its two laps would take 60 s. */
    @Test
    void aRobotThatPassesADoorCarriesOnIfItFollowsTheWallBehindIt() {
        for (double time : new double[] {10, 70}) {
            CarryOnMetrics metrics = withDoor();
            metrics.update(0, new Vector2(2.05, 1), FollowerState.FOLLOW, false);
            driveAround(metrics, time, 2.85, DISTANCE, 6 - DISTANCE, 4 - DISTANCE);
            metrics.update(71, new Vector2(4, 2), FollowerState.FOLLOW, false);
            assertTrue(metrics.carriedOn());
        }
    }

    /** In three rooms with doors, the path of the body through all of them is longer than that around the outside. */
    @Test
    void aRobotHasTheTimeOfTheLongestPathToMeetItsFirstWall() {
        WorldSpec rooms = new WorldSpec(
                6,
                4,
                true,
                3,
                List.of(
                        box("a", 1.9, 0, 2, 1.5),
                        box("b", 1.9, 2, 2, 4),
                        box("c", 4, 0, 4.1, 1.5),
                        box("d", 4, 2, 4.1, 4)));
        WallCircuit circuit = CarryOnMetrics.circuit(rooms, DISTANCE, RobotSpec.DEFAULT);
        assertTrue(circuit.maxLength() < circuit.bodyPaths().maxLength() - 1);
        CarryOnMetrics metrics = new CarryOnMetrics(circuit, 0.5, 0);
        double time = CarryOnMetrics.ALLOWED_LAPS * (circuit.maxLength() / 0.5 + CarryOnMetrics.CORNER_TIME) + 1;
        metrics.update(time, new Vector2(1, 1), FollowerState.SEARCH, false);
        assertFalse(metrics.isDecided());
        metrics.update(time, new Vector2(0.35, 1), FollowerState.FOLLOW, false);
        assertEquals(time, metrics.clockStart().orElseThrow());
    }
}
