package faultline.paint.scene;

import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;
import faultline.geometry.Vector2;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.Shapes;
import faultline.robot.RobotSpec;
import faultline.world.Obstacle;
import java.awt.Color;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.Optional;

/**
 * Paints the feedback of an interaction: previews, the points of a sketch, a rubber band, values, and the reason of a
 * refusal.
 */
public final class InteractionPainter {

    private static final int BAND_ALPHA = 30;
    private static final Stroke EDGE_STROKE = DrawContext.solidStroke(1.4);
    private static final Stroke PREVIEW_STROKE = DrawContext.dashedStroke(1.6, 5, 4);
    private static final double VALUES_GAP = 26;
    private static final double VALUES_PADDING = 8;

    private InteractionPainter() {}

    /** Paints the preview of an obstacle at its wanted position, crossed out if it cannot be there. */
    public static void paintPreview(DrawContext context, Obstacle there, boolean blocked) {
        paintPreview(context, SelectionPainter.screenOutline(context, there), blocked);
    }

    /**
     * Paints the bounding box of the previews of obstacles, at least one, crossed out if one of them cannot be there.
     */
    public static void paintPreview(DrawContext context, ObstacleGroup there, boolean blocked) {
        paintPreview(context, bounds(context, there).orElseThrow(), blocked);
    }

    private static Optional<Rectangle2D> bounds(DrawContext context, ObstacleGroup obstacles) {
        AffineTransform toScreen = context.camera().transform();
        return obstacles.bounds().map(bounds -> toScreen.createTransformedShape(bounds)
                .getBounds2D());
    }

    /** Paints the preview of the robot at its wanted pose, crossed out if it cannot be there. */
    public static void paintRobotPreview(DrawContext context, RobotSpec robot, Pose pose, boolean blocked) {
        RobotPainter.paint(context, robot, pose);
        Shape platform = new Rectangle2D.Double(-robot.length() / 2, -robot.width() / 2, robot.length(), robot.width());
        paintPreview(context, context.toScreen(platform, RigidMotion.poseTransform(pose)), blocked);
    }

    /** Paints an outline, crossed out if it is blocked, because colour alone does not suffice for everyone. */
    private static void paintPreview(DrawContext context, Shape outline, boolean blocked) {
        context.draw(
                outline,
                blocked ? context.palette().collision() : context.palette().accent(),
                PREVIEW_STROKE);
        if (blocked) {
            context.drawCross(outline.getBounds2D(), context.palette().collision());
        }
    }

    /**
     * Paints the points of a sketch in the world, metres, at least one, joined by lines. The last one is under the
     * mouse; if the sketch is closed, it is joined to the first.
     */
    public static void paintSketch(DrawContext context, List<Vector2> points, boolean closed) {
        List<Vector2> places = points.stream().map(context.camera()::toScreen).toList();
        Path2D line = Shapes.polyline(places);
        if (closed) {
            line.closePath();
        }
        context.draw(line, context.palette().accent(), PREVIEW_STROKE);
        places.forEach(place -> SelectionPainter.paintSquareHandle(context, place));
    }

    /** Paints a rubber band between two points, pixels. */
    public static void paintRubberBand(DrawContext context, Vector2 from, Vector2 to) {
        Rectangle2D band = new Rectangle2D.Double();
        band.setFrameFromDiagonal(from.x(), from.y(), to.x(), to.y());
        context.fill(band, Palette.withAlpha(context.palette().accent(), BAND_ALPHA));
        context.draw(band, context.palette().accent(), EDGE_STROKE);
    }

    /**
     * Paints the values that are being changed, below the obstacles at their wanted positions, or else beside the
     * mouse.
     */
    public static void paintValues(DrawContext context, String values, ObstacleGroup there, Vector2 mouse) {
        paintTextBox(context, values, there, mouse, context.palette().accent());
    }

    /** Paints the reason why a change is refused, at the position of {@link #paintValues}. */
    public static void paintRefusal(DrawContext context, String reason, ObstacleGroup there, Vector2 mouse) {
        paintTextBox(context, reason, there, mouse, context.palette().collision());
    }

    /** Paints a text in a box below the obstacles, or else the mouse, moved into the picture if necessary. */
    private static void paintTextBox(
            DrawContext context, String values, ObstacleGroup there, Vector2 mouse, Color edge) {
        Rectangle2D bounds = bounds(context, there).orElse(new Rectangle2D.Double(mouse.x(), mouse.y(), 0, 0));
        Rectangle2D text = context.measureText(values);
        double halfWidth = text.getWidth() / 2 + VALUES_PADDING;
        double halfHeight = text.getHeight() / 2 + VALUES_PADDING / 2;
        double inX = clamp(bounds.getCenterX(), halfWidth, context.camera().width() - halfWidth);
        double inY = clamp(
                bounds.getMaxY() + VALUES_GAP, halfHeight, context.camera().height() - halfHeight);
        Shape box = new RoundRectangle2D.Double(inX - halfWidth, inY - halfHeight, 2 * halfWidth, 2 * halfHeight, 8, 8);
        context.fill(box, context.palette().canvas());
        context.draw(box, edge, EDGE_STROKE);
        context.drawLabel(values, inX, inY, context.palette().text());
    }

    private static double clamp(double value, double least, double most) {
        return Math.max(least, Math.min(most, value));
    }
}
