package faultline.paint.scene;

import faultline.geometry.RigidMotion;
import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.Color;
import java.awt.Font;
import java.awt.Rectangle;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.Rectangle2D;

/**
 * Paints an obstacle: a solid one filled and outlined, a wall as a thick line, a moving one in another colour with a
 * heavier outline, a glossy one with a bright line along its edge.
 */
public record ObstaclePainter(boolean named, Font font) {

    private static final Stroke STATIC_STROKE = DrawContext.solidStroke(1.4);
    private static final Stroke MOVING_STROKE = DrawContext.solidStroke(2);
    /** A wall has no thickness in the world; this width makes it visible. */
    private static final Stroke WALL_STROKE = DrawContext.solidStroke(4);

    private static final Stroke SPECULAR_STROKE = DrawContext.solidStroke(5);
    private static final Stroke HIGHLIGHT_STROKE = DrawContext.solidStroke(2);
    private static final int MOVING_ALPHA = 120;
    /** The minimum size of an obstacle that its name does not hide, pixels. */
    private static final double MIN_SIZE_FOR_NAME = 30;

    private static final double NAME_GAP = 10;
    /** The reach of a name beyond the upper or lower end of an obstacle, pixels. */
    private static final double NAME_HEIGHT = 24;
    /** The reach of an outline, its halo or a selection beyond an obstacle, pixels. */
    private static final double OUTLINE_MARGIN = 4;

    /** The greatest radius of an obstacle that is painted as a dot, pixels. */
    private static final double MAX_DOT_RADIUS = 1;

    /** Paints an obstacle without its route. */
    public void paint(DrawContext context, Obstacle obstacle) {
        if (isDot(context.camera(), obstacle)) {
            paintDot(context, obstacle);
            return;
        }
        paintShape(context, obstacle);
        if (named) {
            paintName(context.withFont(font), obstacle);
        }
    }

    static void paintShape(DrawContext context, Obstacle obstacle) {
        Palette palette = context.palette();
        boolean moves = obstacle.isMoving();
        Color outline = moves ? palette.movingOutline() : palette.obstacleOutline();
        Shape shape = context.toScreen(
                ObstacleOutlines.localShape(obstacle.shape()), RigidMotion.poseTransform(obstacle.pose()));
        if (obstacle.shape() instanceof ObstacleShape.WallShape) {
            context.draw(shape, outline, WALL_STROKE);
        } else {
            context.fill(shape, moves ? Palette.withAlpha(palette.moving(), MOVING_ALPHA) : palette.obstacle());
            context.draw(shape, outline, moves ? MOVING_STROKE : STATIC_STROKE);
        }
        if (obstacle.isSpecular()) {
            context.draw(shape, outline, SPECULAR_STROKE);
            context.draw(shape, palette.canvas(), HIGHLIGHT_STROKE);
        }
    }

    /**
     * Returns whether an obstacle is painted as a dot: it is about as small as a pixel, so that a dot shows as much as
     * its outline.
     */
    public boolean isDot(Camera camera, Obstacle obstacle) {
        return !named && !obstacle.isMoving() && obstacle.shape().boundingRadius() * camera.scale() < MAX_DOT_RADIUS;
    }

    /** Paints an obstacle as a dot, many times faster than its outline. */
    private static void paintDot(DrawContext context, Obstacle obstacle) {
        Vector2 centre = context.camera().toScreen(obstacle.pose().position());
        context.fill(
                new Rectangle((int) Math.rint(centre.x()) - 1, (int) Math.rint(centre.y()) - 1, 2, 2),
                context.palette().obstacleOutline());
    }

    /** Returns the bounds of the outline and, if it is painted, of the name, pixels. */
    public Rectangle2D bounds(Camera camera, Obstacle obstacle) {
        if (!named) {
            return paintedBounds(camera, obstacle, 0, OUTLINE_MARGIN);
        }
        double halfName =
                font.getStringBounds(obstacle.id(), DrawContext.FONT_CONTEXT).getWidth() / 2;
        return paintedBounds(
                camera, obstacle, halfName, NAME_HEIGHT * font.getSize2D() / DrawContext.DEFAULT_FONT.getSize2D());
    }

    private static Rectangle2D paintedBounds(Camera camera, Obstacle obstacle, double halfName, double above) {
        Rectangle2D bounds = camera.transform()
                .createTransformedShape(ObstacleOutlines.worldShape(obstacle))
                .getBounds2D();
        double across = Math.max(bounds.getWidth() / 2, halfName) + OUTLINE_MARGIN;
        double up = bounds.getHeight() / 2 + above;
        return new Rectangle2D.Double(bounds.getCenterX() - across, bounds.getCenterY() - up, 2 * across, 2 * up);
    }

    /** Paints the name in the middle of an obstacle, or above it if it would hide the obstacle. */
    private static void paintName(DrawContext context, Obstacle obstacle) {
        Rectangle2D bounds =
                context.toScreen(ObstacleOutlines.worldShape(obstacle)).getBounds2D();
        boolean hides = Math.max(bounds.getWidth(), bounds.getHeight()) < MIN_SIZE_FOR_NAME;
        double y = hides ? bounds.getMinY() - context.scaleToFont(NAME_GAP) : bounds.getCenterY();
        context.drawLabel(
                obstacle.id(), bounds.getCenterX(), y, context.palette().text());
    }
}
