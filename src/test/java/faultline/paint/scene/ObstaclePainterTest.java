package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.RecordingSurface;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import java.awt.Font;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.junit.jupiter.api.Test;

class ObstaclePainterTest {

    private static final Camera CAMERA = new Camera(0, 0, 100, 400, 300);
    private static final Font FONT = DrawContext.DEFAULT_FONT;
    private static final ObstaclePainter NAMED = new ObstaclePainter(true, FONT);
    private static final ObstaclePainter UNNAMED = new ObstaclePainter(false, FONT);

    private final RecordingSurface drawn = new RecordingSurface();
    private final DrawContext context = new DrawContext(drawn, CAMERA, Palette.LIGHT, FONT);

    private static Obstacle disc(double radius) {
        return new Obstacle("a disc", new ObstacleShape.CircleShape(radius), new Pose(0.502, 0.5, 0));
    }

    private static Obstacle moving(double radius) {
        return disc(radius).withMotion(new WaypointPath(0.1, true, List.of(new Vector2(0, 0), new Vector2(1, 0))));
    }

    /** Returns the height of a name in the picture, pixels. */
    private double nameY(Obstacle obstacle) {
        drawn.clear();
        NAMED.paint(context, obstacle);
        assertEquals(1, drawn.texts().size());
        return Double.parseDouble(drawn.texts().get(0).replaceFirst("a disc at [\\d.]+,", ""));
    }

    @Test
    void theNameIsInTheMiddleOfALargeObstacleAndAboveASmallOne() {
        double inTheMiddle = nameY(disc(0.15));
        assertEquals(inTheMiddle, nameY(disc(0.4)), "of 30 pixels or more");
        assertEquals(inTheMiddle - 14 - 10, nameY(disc(0.14)), 0.1 + 1e-9, "10 pixels above the upper end");
        drawn.clear();
        UNNAMED.paint(context, disc(0.4));
        assertEquals(List.of(), drawn.texts());
    }

    @Test
    void aTinyObstacleWithoutANameIsADotOfFourPixels() {
        Obstacle tiny = disc(0.009);
        assertTrue(UNNAMED.isDot(CAMERA, tiny));
        UNNAMED.paint(context, tiny);
        assertEquals(1, drawn.shapes().size());
        assertEquals(
                new Rectangle2D.Double(249, 99, 2, 2),
                drawn.shapes(Palette.LIGHT.obstacleOutline()).get(0).shape().getBounds2D());
        assertFalse(NAMED.isDot(CAMERA, tiny));
        assertFalse(UNNAMED.isDot(CAMERA, moving(0.009)));
        assertFalse(UNNAMED.isDot(CAMERA, disc(0.01)), "of a radius of a pixel");
    }

    @Test
    void theBoundsContainTheOutlineAndTheName() {
        assertBounds(new Rectangle2D.Double(250.2 - 24, 100 - 24, 48, 48), UNNAMED.bounds(CAMERA, disc(0.2)));
        double halfName =
                FONT.getStringBounds("a disc", DrawContext.FONT_CONTEXT).getWidth() / 2;
        assertBounds(
                new Rectangle2D.Double(250.2 - halfName - 4, 100 - 25, 2 * halfName + 8, 50),
                NAMED.bounds(CAMERA, disc(0.01)));
        assertBounds(new Rectangle2D.Double(250.2 - 104, 100 - 124, 208, 248), NAMED.bounds(CAMERA, disc(1)));
        ObstaclePainter large = new ObstaclePainter(true, FONT.deriveFont(2 * FONT.getSize2D()));
        assertEquals(2 * 100 + 2 * 48, large.bounds(CAMERA, disc(1)).getHeight(), 1e-6);
    }

    private static void assertBounds(Rectangle2D expected, Rectangle2D bounds) {
        assertEquals(expected.getX(), bounds.getX(), 1e-6);
        assertEquals(expected.getY(), bounds.getY(), 1e-6);
        assertEquals(expected.getWidth(), bounds.getWidth(), 1e-6);
        assertEquals(expected.getHeight(), bounds.getHeight(), 1e-6);
    }
}
