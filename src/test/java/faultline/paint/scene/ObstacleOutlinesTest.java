package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.Shape;
import java.awt.geom.PathIterator;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.junit.jupiter.api.Test;

class ObstacleOutlinesTest {

    private static final double QUARTER_TURN = Math.PI / 2;

    @Test
    void rectanglesCirclesAndEllipsesAreCentredOnTheOrigin() {
        assertEquals(
                new Rectangle2D.Double(-1, -0.5, 2, 1),
                ObstacleOutlines.localShape(new ObstacleShape.RectangleShape(2, 1))
                        .getBounds2D());
        assertEquals(
                new Rectangle2D.Double(-1, -1, 2, 2),
                ObstacleOutlines.localShape(new ObstacleShape.CircleShape(1)).getBounds2D());
        assertEquals(
                new Rectangle2D.Double(-2, -1, 4, 2),
                ObstacleOutlines.localShape(new ObstacleShape.EllipseShape(2, 1))
                        .getBounds2D());
        assertFalse(ObstacleOutlines.localShape(new ObstacleShape.EllipseShape(2, 1))
                .contains(1.9, 0.9));
    }

    @Test
    void aPolygonIsFilledByTheEvenOddRule() {
        List<Vector2> bowlTwice = List.of(
                new Vector2(0, 0),
                new Vector2(3, 0),
                new Vector2(3, 3),
                new Vector2(0, 3),
                new Vector2(0, 0),
                new Vector2(1, 1),
                new Vector2(2, 1),
                new Vector2(2, 2),
                new Vector2(1, 2),
                new Vector2(1, 1));
        Shape outline = ObstacleOutlines.localShape(new ObstacleShape.PolygonShape(bowlTwice));
        assertTrue(outline.contains(0.5, 2));
        assertFalse(outline.contains(1.5, 1.5), "the hole is not inside");
    }

    private static List<Vector2> square(double side) {
        return List.of(new Vector2(0, 0), new Vector2(side, 0), new Vector2(side, side), new Vector2(0, side));
    }

    @Test
    void aFloorPlanHasRoomsWithinWalls() {
        List<Vector2> room =
                square(2).stream().map(corner -> corner.plus(new Vector2(1, 1))).toList();
        Shape outline = ObstacleOutlines.localShape(new ObstacleShape.PlanShape(List.of(square(4), room)));
        assertEquals(new Rectangle2D.Double(0, 0, 4, 4), outline.getBounds2D());
        assertTrue(outline.contains(0.5, 2));
        assertFalse(outline.contains(2, 2));
    }

    @Test
    void thePolygonIsClosedAndTheWallIsNot() {
        assertEquals(1, closings(new ObstacleShape.PolygonShape(square(1))));
        assertEquals(0, closings(new ObstacleShape.WallShape(square(1))));
    }

    private static int closings(ObstacleShape shape) {
        int count = 0;
        double[] point = new double[6];
        for (PathIterator i = ObstacleOutlines.localShape(shape).getPathIterator(null); !i.isDone(); i.next()) {
            count += i.currentSegment(point) == PathIterator.SEG_CLOSE ? 1 : 0;
        }
        return count;
    }

    @Test
    void anObstacleIsPlacedAtItsPose() {
        Shape placed = ObstacleOutlines.worldShape(
                new Obstacle("plank", new ObstacleShape.RectangleShape(2, 1), new Pose(5, 3, QUARTER_TURN)));
        assertTrue(placed.contains(5.4, 3.9));
        assertFalse(placed.contains(5.9, 3.4));
    }

    @Test
    void rotatingLeavesTheCentreInPlace() {
        ObstacleShape triangle =
                new ObstacleShape.PolygonShape(List.of(new Vector2(1, 1), new Vector2(3, 1), new Vector2(3, 2)));
        Obstacle niche = new Obstacle("niche", triangle, new Pose(4, 0, 0));
        Vector2 middle = ObstacleOutlines.centre(niche);
        assertEquals(new Vector2(6, 1.5), middle);
        Obstacle turned =
                niche.withPose(ObstacleOutlines.rotatedPose(niche, ObstacleOutlines.centre(niche), QUARTER_TURN));
        assertEquals(0, ObstacleOutlines.centre(turned).distanceTo(middle), 1e-12);
        assertEquals(QUARTER_TURN, turned.pose().heading());
    }
}
