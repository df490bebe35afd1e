package faultline.paint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.Shape;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.junit.jupiter.api.Test;

class ObstacleOutlinesTest {

    private static final double QUARTER = Math.PI / 2;

    @Test
    void rectanglesCirclesAndEllipsesLieAboutTheOrigin() {
        assertEquals(new Rectangle2D.Double(-1, -0.5, 2, 1), ObstacleOutlines.local(new ObstacleShape.Rectangle(2, 1)).getBounds2D());
        assertEquals(new Rectangle2D.Double(-1, -1, 2, 2), ObstacleOutlines.local(new ObstacleShape.Circle(1)).getBounds2D());
        assertEquals(new Rectangle2D.Double(-2, -1, 4, 2), ObstacleOutlines.local(new ObstacleShape.Ellipse(2, 1)).getBounds2D());
        assertFalse(ObstacleOutlines.local(new ObstacleShape.Ellipse(2, 1)).contains(1.9, 0.9));
    }

    @Test
    void aPolygonIsFilledByTheEvenOddRule() {
        List<Vec> bowlTwice = List.of(new Vec(0, 0), new Vec(3, 0), new Vec(3, 3), new Vec(0, 3), new Vec(0, 0),
                new Vec(1, 1), new Vec(2, 1), new Vec(2, 2), new Vec(1, 2), new Vec(1, 1));
        Shape outline = ObstacleOutlines.local(new ObstacleShape.Polygon(bowlTwice));
        assertTrue(outline.contains(0.5, 2));
        assertFalse(outline.contains(1.5, 1.5), "the hole is not inside");
    }

    @Test
    void anObstacleStandsAtItsPose() {
        Shape placed = ObstacleOutlines.inWorld(new Obstacle("plank", new ObstacleShape.Rectangle(2, 1), new Pose(5, 3, QUARTER)));
        assertTrue(placed.contains(5.4, 3.9));
        assertFalse(placed.contains(5.9, 3.4));
    }

    @Test
    void turningByHandLeavesTheMiddleWhereItIs() {
        ObstacleShape triangle = new ObstacleShape.Polygon(List.of(new Vec(1, 1), new Vec(3, 1), new Vec(3, 2)));
        Obstacle niche = new Obstacle("niche", triangle, new Pose(4, 0, 0));
        Vec middle = ObstacleOutlines.middle(niche);
        assertEquals(new Vec(6, 1.5), middle);
        Obstacle turned = niche.at(ObstacleOutlines.turned(niche, ObstacleOutlines.middle(niche), QUARTER));
        assertEquals(0, ObstacleOutlines.middle(turned).distanceTo(middle), 1e-12);
        assertEquals(QUARTER, turned.pose().heading());
    }
}
