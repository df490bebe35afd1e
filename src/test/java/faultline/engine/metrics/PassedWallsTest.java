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
 * through them, but the body is only 0.2 m wide. At 0.5 m/s the robot has more than 100 s in each room.
 */
class PassedWallsTest {

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

    /** The box is 0.5 m from the lower wall, so its path and that of the room are one path of 21 m. */
    private static CarryOnMetrics withBox() {
        return metrics(box("box", 2.5, 0.5, 3.5, 1.5));
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
        assertEquals(0.2, metrics.share().orElseThrow(), 0.1);
        driveAroundBox(metrics, 20);
        assertFalse(metrics.carriedOn(), "two laps of the box are shorter than 0.8 of the path");
        driveAroundBox(metrics, 30);
        assertTrue(metrics.carriedOn());
        assertEquals(1, metrics.share().orElseThrow(), 1e-9);
        assertEquals(3, metrics.laps().orElseThrow(), 0.1);
    }

    @Test
    void aRobotThatPassesAndFollowsTheRoomCarriesOn() {
        CarryOnMetrics metrics = withBox();
        driveAroundRoom(metrics, 10);
        driveAroundRoom(metrics, 20);
        assertTrue(metrics.carriedOn());
        assertEquals(1, metrics.share().orElseThrow(), 1e-9);
    }

    @Test
    void aRobotThatCirclesTheBoxTooLateDoesNotCarryOn() {
        CarryOnMetrics metrics = withBox();
        driveAroundBox(metrics, 10);
        driveAroundBox(metrics, 20);
        driveAroundBox(metrics, 200);
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
        assertFalse(metrics.carriedOn());
        assertEquals(0.1, metrics.share().orElseThrow(), 0.05);
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
        assertFalse(away.carriedOn());
    }

    /** The box is 0.18 m from the lower wall. */
    @Test
    void aBoxThatTheBodyCannotPassBelongsToTheWall() {
        CarryOnMetrics metrics = metrics(box("box", 2.5, 0.18, 3.5, 1.2));
        for (int i = 0; i < 10; i++) {
            driveAround(metrics, 10, 2.15, 0.1, 3.85, 1.55);
        }
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

    @Test
    void aRobotThatPassesADoorCarriesOnIfItFollowsTheWallBehindIt() {
        CarryOnMetrics metrics = withDoor();
        metrics.update(0, new Vector2(2.05, 1), FollowerState.FOLLOW, false);
        driveAround(metrics, 10, 2.85, DISTANCE, 6 - DISTANCE, 4 - DISTANCE);
        assertTrue(metrics.carriedOn());
    }

    @Test
    void aRobotThatPassesADoorHasTheTimeOfBothSides() {
        CarryOnMetrics metrics = withDoor();
        metrics.update(0, new Vector2(2.05, 1), FollowerState.FOLLOW, false);
        // The path of this side is 10 m long, so that its two laps would take 60 s.
        driveAround(metrics, 70, 2.85, DISTANCE, 6 - DISTANCE, 4 - DISTANCE);
        assertTrue(metrics.carriedOn());
    }

    /** Half its width is more than the wanted distance. */
    @Test
    void aRobotThatFillsThePassageHasNoOtherPaths() {
        WorldSpec pole = new WorldSpec(
                4, 4, false, 3, List.of(new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(2, 2, 0))));
        RobotSpec wide = RobotSpec.DEFAULT.withPlatform(0.8, 0.8, 0.3);
        WallCircuit circuit = CarryOnMetrics.circuit(pole, DISTANCE, wide);
        assertEquals(circuit.path(circuit.size() - 1), circuit.bodyPath(circuit.size() - 1));
        assertEquals(circuit.maxLength(), circuit.bodyLength(0));
    }
}
