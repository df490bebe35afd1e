package faultline.gui.canvas.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class ObstacleFinderTest {

    /** A camera of 100 pixels per metre with the origin at the centre of 800 x 600 pixels. */
    private static final Camera CAMERA = new Camera(0, 0, 100, 800, 600);

    private static final Obstacle BOX = new Obstacle("box", new ObstacleShape.RectangleShape(2, 1), Pose.ORIGIN);
    private static final Obstacle WALL = new Obstacle(
            "wall",
            new ObstacleShape.WallShape(List.of(new Vector2(0, 0), new Vector2(1, 0), new Vector2(1, 1))),
            new Pose(-3, 2, 0));

    @Test
    void theObstacleUnderTheMouseIsFound() {
        assertEquals(Optional.of("box"), at(new Vector2(0.9, 0.4), BOX, WALL));
        assertEquals(Optional.empty(), at(new Vector2(1.2, 0), BOX, WALL));
    }

    @Test
    void aThinWallIsFoundBesideItsLine() {
        assertEquals(Optional.of("wall"), at(new Vector2(-2.5, 2.03), BOX, WALL));
        assertEquals(Optional.of("wall"), at(new Vector2(-2.04, 2.5), BOX, WALL));
        assertEquals(Optional.empty(), at(new Vector2(-2.5, 2.2), BOX, WALL));
    }

    @Test
    void anOpenWallIsNotFoundBetweenItsEnds() {
        assertEquals(Optional.empty(), at(new Vector2(-2.5, 2.5), WALL));
    }

    @Test
    void aPoleOfAMillimetreCanBeCaught() {
        Obstacle pole = new Obstacle("pole", new ObstacleShape.CircleShape(0.0005), new Pose(3, 0, 0));
        assertEquals(Optional.of("pole"), at(new Vector2(3.03, 0), pole));
        assertEquals(Optional.empty(), at(new Vector2(3.1, 0), pole));
    }

    @Test
    void theTurnOfAnObstacleCounts() {
        Obstacle turned = BOX.withPose(new Pose(0, 0, Math.PI / 2));
        assertEquals(Optional.of("box"), at(new Vector2(0, 0.9), turned));
        assertEquals(Optional.empty(), at(new Vector2(0.9, 0), turned));
    }

    @Test
    void ofTwoTheOneOnTopIsFound() {
        Obstacle upper = new Obstacle("upper", new ObstacleShape.CircleShape(0.3), Pose.ORIGIN);
        assertEquals(Optional.of("upper"), at(Vector2.ZERO, BOX, upper));
        assertEquals(Optional.of("box"), at(Vector2.ZERO, upper, BOX));
    }

    @Test
    void aMovingObstacleLiesOnTopWhateverTheOrder() {
        Obstacle visitor = new Obstacle(
                "visitor",
                new ObstacleShape.CircleShape(0.3),
                Pose.ORIGIN,
                new WaypointPath(1, false, List.of(Vector2.ZERO)));
        assertEquals(Optional.of("visitor"), at(Vector2.ZERO, visitor, BOX));
    }

    private static Optional<String> at(Vector2 world, Obstacle... obstacles) {
        return ObstacleFinder.topmostAt(CAMERA, List.of(obstacles), CAMERA.toScreen(world))
                .map(Obstacle::id);
    }
}
