package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** What is painted about several obstacles in every frame. */
class ObstacleGroupTest {

    private static Obstacle box(double x, double y) {
        return new Obstacle("box", new ObstacleShape.RectangleShape(1, 0.5), new Pose(x, y, 0));
    }

    @Test
    void theBoundsAreAroundAllAndTheCentreIsTheMeanOfTheirs() {
        Obstacle corner = new Obstacle(
                "corner",
                new ObstacleShape.PolygonShape(List.of(new Vector2(2, 0), new Vector2(4, 0), new Vector2(2, 2))),
                new Pose(0, 0, 0));
        ObstacleGroup group = ObstacleGroup.of(List.of(box(0, 0), corner));
        assertEquals(
                new Rectangle2D.Double(-0.5, -0.25, 4.5, 2.25), group.bounds().orElseThrow());
        assertEquals(new Vector2(1.5, 0.5), group.centre());
        assertEquals(ObstacleOutlines.centre(List.of(box(0, 0), corner)), group.centre());
        assertEquals(Optional.empty(), ObstacleGroup.NONE.bounds());
    }

    @Test
    void itIsMadeAgainOnlyIfAnObstacleHasChanged() {
        List<Obstacle> obstacles = new ArrayList<>(List.of(box(0, 0), box(1, 0)));
        ObstacleGroup group = ObstacleGroup.of(obstacles);
        assertSame(group, group.with(List.of(box(0, 0), box(1, 0))));
        obstacles.set(1, box(2, 0));
        ObstacleGroup moved = group.with(obstacles);
        assertNotSame(group, moved);
        assertEquals(new Vector2(1, 0), moved.centre());
        assertEquals(new Vector2(0.5, 0), group.centre());
    }
}
