package faultline.paint;

import faultline.geometry.RigidMotion;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.font.FontRenderContext;
import java.awt.geom.Rectangle2D;
import java.util.Optional;

/**
 * Paints one obstacle: a solid one filled and outlined, a wall as a thick line, a moving one in another colour and with a heavier
 * outline, a glossy one with a bright line along its edge.
 */
final class ObstaclePainter {

    private static final Stroke STILL = Brush.solid(1.4);
    private static final Stroke MOVING = Brush.solid(2);
    /** A wall has no thickness in the world; this much makes it seen. */
    private static final Stroke WALL = Brush.solid(4);
    private static final Stroke GLOSSY = Brush.solid(5);
    private static final Stroke GLOSS = Brush.solid(2);
    private static final int MOVING_ALPHA = 120;
    /** An obstacle smaller than this on the screen would be hidden by its name, pixels. */
    private static final double SMALL = 30;
    private static final double NAME_GAP = 10;
    /** How far a name may reach beyond an obstacle's upper or lower end, pixels. */
    private static final double NAME_HEIGHT = 24;
    /** How far an outline, its halo or a mark of selection may reach beyond an obstacle, pixels. */
    private static final double BLEED = 4;
    private static final FontRenderContext FONTS = new FontRenderContext(null, true, true);

    private ObstaclePainter() {
    }

    static void paint(Brush brush, Obstacle obstacle) {
        Palette palette = brush.palette();
        boolean moves = obstacle.motion().isPresent();
        Color outline = moves ? palette.movingOutline() : palette.obstacleOutline();
        Shape shape = brush.onScreen(ObstacleOutlines.local(obstacle.shape()), RigidMotion.to(obstacle.pose()));
        if (obstacle.shape() instanceof ObstacleShape.Wall) {
            brush.draw(shape, outline, WALL);
        } else {
            brush.fill(shape, moves ? Palette.translucent(palette.moving(), MOVING_ALPHA) : palette.obstacle());
            brush.draw(shape, outline, moves ? MOVING : STILL);
        }
        if (obstacle.isGlossy()) {
            brush.draw(shape, outline, GLOSSY);
            brush.draw(shape, palette.canvas(), GLOSS);
        }
    }

    /** Where the outline, and the name if there is a font for it, leave marks, pixels. */
    static Rectangle2D extent(Camera camera, Obstacle obstacle, Optional<Font> names) {
        Rectangle2D bounds = camera.transform().createTransformedShape(ObstacleOutlines.inWorld(obstacle)).getBounds2D();
        double halfName = names.map(font -> font.getStringBounds(obstacle.id(), FONTS).getWidth() / 2).orElse(0.0);
        double across = Math.max(bounds.getWidth() / 2, halfName) + BLEED;
        double up = bounds.getHeight() / 2 + names.map(font -> NAME_HEIGHT * font.getSize2D() / Brush.FONT.getSize2D()).orElse(BLEED);
        return new Rectangle2D.Double(bounds.getCenterX() - across, bounds.getCenterY() - up, 2 * across, 2 * up);
    }

    /** Paints the name in the middle of an obstacle, or above one that it would hide. */
    static void paintName(Brush brush, Obstacle obstacle) {
        Rectangle2D bounds = brush.onScreen(ObstacleOutlines.inWorld(obstacle)).getBounds2D();
        boolean hides = Math.max(bounds.getWidth(), bounds.getHeight()) < SMALL;
        double y = hides ? bounds.getMinY() - brush.enlarged(NAME_GAP) : bounds.getCenterY();
        brush.label(obstacle.id(), bounds.getCenterX(), y, brush.palette().text());
    }
}
