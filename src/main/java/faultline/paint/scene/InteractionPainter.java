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
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.Optional;

/**
 * Paints what a hand is about: where it wants things, by what values, what it draws, and why it cannot have what it
 * wants.
 */
public final class InteractionPainter {

    private static final int BAND_ALPHA = 30;
    private static final Stroke EDGE_STROKE = DrawContext.solidStroke(1.4);
    private static final Stroke CROSS_STROKE = DrawContext.solidStroke(2);
    private static final Stroke PREVIEW_STROKE = DrawContext.dashedStroke(1.6, 5, 4);
    private static final double VALUES_GAP = 26;
    private static final double VALUES_PADDING = 8;

    private InteractionPainter() {}

    /**
     * Paints where a hand wants an obstacle, which the world need not have done yet.
     *
     * @param brush where to
     * @param there the obstacle as it is wanted
     * @param blocked whether it cannot be there
     */
    public static void paintPreview(DrawContext brush, Obstacle there, boolean blocked) {
        paintPreview(brush, SelectionPainter.screenOutline(brush, there), blocked);
    }

    /**
     * Paints a frame about where a hand wants many obstacles, which the world need not have done yet.
     *
     * @param brush where to
     * @param there the obstacles as they are wanted, at least one
     * @param blocked whether one of them cannot be there
     */
    public static void paintPreview(DrawContext brush, List<Obstacle> there, boolean blocked) {
        paintPreview(brush, bounds(brush, there).orElseThrow(), blocked);
    }

    private static Optional<Rectangle2D> bounds(DrawContext brush, List<Obstacle> obstacles) {
        return obstacles.stream()
                .map(obstacle -> SelectionPainter.screenOutline(brush, obstacle).getBounds2D())
                .reduce(Rectangle2D::createUnion);
    }

    /**
     * Paints where a hand wants the robot.
     *
     * @param brush where to
     * @param robot the robot
     * @param pose its wanted pose
     * @param blocked whether it cannot be there
     */
    public static void paintRobotPreview(DrawContext brush, RobotSpec robot, Pose pose, boolean blocked) {
        RobotPainter.paint(brush, robot, pose);
        Shape platform = new Rectangle2D.Double(-robot.length() / 2, -robot.width() / 2, robot.length(), robot.width());
        paintPreview(brush, brush.toScreen(platform, RigidMotion.poseTransform(pose)), blocked);
    }

    /** What cannot be is crossed out besides, because a colour alone says nothing to some. */
    private static void paintPreview(DrawContext brush, Shape outline, boolean blocked) {
        brush.draw(
                outline, blocked ? brush.palette().contact() : brush.palette().accent(), PREVIEW_STROKE);
        if (blocked) {
            Rectangle2D box = outline.getBounds2D();
            brush.draw(
                    new Line2D.Double(box.getMinX(), box.getMinY(), box.getMaxX(), box.getMaxY()),
                    brush.palette().contact(),
                    CROSS_STROKE);
            brush.draw(
                    new Line2D.Double(box.getMinX(), box.getMaxY(), box.getMaxX(), box.getMinY()),
                    brush.palette().contact(),
                    CROSS_STROKE);
        }
    }

    /**
     * Paints points that are being drawn, joined by lines.
     *
     * @param brush where to
     * @param points metres, in the world, at least one; the last is under the mouse
     * @param closed whether the last is joined to the first
     */
    public static void paintSketch(DrawContext brush, List<Vector2> points, boolean closed) {
        List<Vector2> places = points.stream().map(brush.camera()::toScreen).toList();
        Path2D line = Shapes.polyline(places);
        if (closed) {
            line.closePath();
        }
        brush.draw(line, brush.palette().accent(), PREVIEW_STROKE);
        places.forEach(place -> SelectionPainter.paintSquareHandle(brush, place));
    }

    /**
     * Paints a rubber band.
     *
     * @param brush where to
     * @param from where it began, pixels
     * @param to where it is, pixels
     */
    public static void paintRubberBand(DrawContext brush, Vector2 from, Vector2 to) {
        Rectangle2D band = new Rectangle2D.Double();
        band.setFrameFromDiagonal(from.x(), from.y(), to.x(), to.y());
        brush.fill(band, Palette.withAlpha(brush.palette().accent(), BAND_ALPHA));
        brush.draw(band, brush.palette().accent(), EDGE_STROKE);
    }

    /**
     * Paints what a hand is changing, in words: below the obstacles that it changes, or else beside the mouse.
     *
     * @param brush where to
     * @param values such as {@code x 1.20 m}
     * @param there the obstacles as they are wanted
     * @param mouse pixels
     */
    public static void paintValues(DrawContext brush, String values, List<Obstacle> there, Vector2 mouse) {
        paintTextBox(
                brush,
                values,
                positionBelow(brush, there, mouse),
                brush.palette().accent());
    }

    /**
     * Paints why a hand cannot have what it wants, where {@link #paintValues} paints values.
     *
     * @param brush where to
     * @param reason one sentence
     * @param there the obstacles as they are wanted
     * @param mouse pixels
     */
    public static void paintRefusal(DrawContext brush, String reason, List<Obstacle> there, Vector2 mouse) {
        paintTextBox(
                brush,
                reason,
                positionBelow(brush, there, mouse),
                brush.palette().contact());
    }

    private static Vector2 positionBelow(DrawContext brush, List<Obstacle> there, Vector2 mouse) {
        Rectangle2D bounds = bounds(brush, there).orElse(new Rectangle2D.Double(mouse.x(), mouse.y(), 0, 0));
        return new Vector2(bounds.getCenterX(), bounds.getMaxY() + VALUES_GAP);
    }

    /** A plate about a place, moved into the picture where the place is not. */
    private static void paintTextBox(DrawContext brush, String values, Vector2 place, Color edge) {
        Rectangle2D text = brush.measureText(values);
        double halfWidth = text.getWidth() / 2 + VALUES_PADDING;
        double halfHeight = text.getHeight() / 2 + VALUES_PADDING / 2;
        double inX = clamp(place.x(), halfWidth, brush.camera().width() - halfWidth);
        double inY = clamp(place.y(), halfHeight, brush.camera().height() - halfHeight);
        Shape plate =
                new RoundRectangle2D.Double(inX - halfWidth, inY - halfHeight, 2 * halfWidth, 2 * halfHeight, 8, 8);
        brush.fill(plate, brush.palette().canvas());
        brush.draw(plate, edge, EDGE_STROKE);
        brush.drawLabel(values, inX, inY, brush.palette().text());
    }

    private static double clamp(double value, double least, double most) {
        return Math.max(least, Math.min(most, value));
    }
}
