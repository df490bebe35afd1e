package faultline.paint.scene;

import faultline.geometry.RigidMotion;
import faultline.geometry.Sector;
import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.world.Obstacle;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.List;

/** Paints what is selected: outlines, and the handles by which a hand takes hold of it. */
public final class SelectionPainter {

    /** The radius of the handle, pixels. */
    public static final double HANDLE_RADIUS = 6;

    private static final double SQUARE_SIZE = 7;
    /** How far along a cone's edge its handle is. */
    private static final double EDGE_HANDLE_POSITION = 0.75;

    private static final double STALK_LENGTH = 24;
    private static final Stroke OUTLINE_STROKE = DrawContext.solidStroke(2);
    private static final Stroke HANDLE_STROKE = DrawContext.solidStroke(1.4);

    private SelectionPainter() {}

    /**
     * Where the handle that turns an obstacle is: above its middle while its heading is 0, and turning with it.
     *
     * @param camera from the world to the picture
     * @param obstacle the obstacle
     * @return pixels
     */
    public static Vector2 handlePosition(Camera camera, Obstacle obstacle) {
        return stalkEnd(camera, obstacle, STALK_LENGTH);
    }

    /**
     * Where the handle that turns several obstacles about their common middle is: above all of them.
     *
     * @param camera from the world to the picture
     * @param obstacles the obstacles, at least one
     * @return pixels
     */
    public static Vector2 handlePosition(Camera camera, List<Obstacle> obstacles) {
        double top = obstacles.stream()
                .mapToDouble(obstacle ->
                        ObstacleOutlines.worldShape(obstacle).getBounds2D().getMaxY())
                .max()
                .orElseThrow();
        Vector2 above =
                camera.toScreen(new Vector2(ObstacleOutlines.centre(obstacles).x(), top));
        return new Vector2(above.x(), above.y() - STALK_LENGTH);
    }

    private static Vector2 stalkEnd(Camera camera, Obstacle obstacle, double beyond) {
        Rectangle2D bounds = ObstacleOutlines.localShape(obstacle.shape()).getBounds2D();
        double up = bounds.getHeight() / 2 * camera.scale() + beyond;
        Vector2 middle = camera.toScreen(ObstacleOutlines.centre(obstacle));
        Vector2 direction = Vector2.direction(obstacle.pose().heading()).perpendicular();
        return new Vector2(middle.x() + up * direction.x(), middle.y() - up * direction.y());
    }

    /**
     * Paints the outline of a selected obstacle.
     *
     * @param brush where to
     * @param obstacle the obstacle as it stands
     */
    public static void paintOutline(DrawContext brush, Obstacle obstacle) {
        brush.draw(screenOutline(brush, obstacle), brush.palette().accent(), OUTLINE_STROKE);
    }

    /**
     * Paints the handles of the only selected obstacle.
     *
     * @param brush where to
     * @param obstacle the obstacle as it stands
     * @param places of the handles that change its size, metres
     */
    public static void paintHandles(DrawContext brush, Obstacle obstacle, List<Vector2> places) {
        paintHandle(brush, stalkEnd(brush.camera(), obstacle, 0), handlePosition(brush.camera(), obstacle));
        places.stream().map(brush.camera()::toScreen).forEach(place -> paintSquareHandle(brush, place));
    }

    /**
     * Paints the handle of several selected obstacles.
     *
     * @param brush where to
     * @param obstacles the obstacles as they stand, at least one
     */
    public static void paintHandle(DrawContext brush, List<Obstacle> obstacles) {
        paintHandle(
                brush,
                brush.camera().toScreen(ObstacleOutlines.centre(obstacles)),
                handlePosition(brush.camera(), obstacles));
    }

    private static void paintHandle(DrawContext brush, Vector2 foot, Vector2 handle) {
        brush.draw(
                new Line2D.Double(foot.x(), foot.y(), handle.x(), handle.y()),
                brush.palette().accent(),
                HANDLE_STROKE);
        paintKnob(
                brush,
                new Ellipse2D.Double(
                        handle.x() - HANDLE_RADIUS, handle.y() - HANDLE_RADIUS, 2 * HANDLE_RADIUS, 2 * HANDLE_RADIUS));
    }

    /** A square about a place of the picture. */
    static void paintSquareHandle(DrawContext brush, Vector2 place) {
        paintKnob(
                brush,
                new Rectangle2D.Double(
                        place.x() - SQUARE_SIZE / 2, place.y() - SQUARE_SIZE / 2, SQUARE_SIZE, SQUARE_SIZE));
    }

    private static void paintKnob(DrawContext brush, Shape knob) {
        brush.fill(knob, brush.palette().canvas());
        brush.draw(knob, brush.palette().accent(), HANDLE_STROKE);
    }

    /**
     * Paints the outline of the selected sensor's cone, with handles on its rim and its edges.
     *
     * @param brush where to
     * @param sector the cone
     */
    public static void paintCone(DrawContext brush, Sector sector) {
        ScreenSector cone = ScreenSector.of(brush.camera(), sector);
        brush.draw(cone.outline(), brush.palette().accent(), OUTLINE_STROKE);
        paintSquareHandle(brush, cone.pointAt(0.5, cone.radius()));
        paintSquareHandle(brush, cone.pointAt(0, cone.radius() * EDGE_HANDLE_POSITION));
        paintSquareHandle(brush, cone.pointAt(1, cone.radius() * EDGE_HANDLE_POSITION));
    }

    /** The outline of an obstacle in the picture. */
    static Shape screenOutline(DrawContext brush, Obstacle obstacle) {
        return brush.toScreen(
                ObstacleOutlines.localShape(obstacle.shape()), RigidMotion.poseTransform(obstacle.pose()));
    }
}
