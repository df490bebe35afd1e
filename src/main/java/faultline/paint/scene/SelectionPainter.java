package faultline.paint.scene;

import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;
import faultline.geometry.Sector;
import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Shapes;
import faultline.world.Obstacle;
import java.awt.Rectangle;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.Rectangle2D;
import java.util.List;

/** Paints the selection: outlines and handles. */
public final class SelectionPainter {

    /** The radius of a rotation handle, pixels. */
    public static final double HANDLE_RADIUS = 6;

    private static final double WAYPOINT_RADIUS = 4;

    private static final double SQUARE_SIZE = 7;
    /** The position of the handle on a cone's edge, as a fraction of its length. */
    private static final double EDGE_HANDLE_POSITION = 0.75;

    private static final double STALK_LENGTH = 24;
    private static final Stroke OUTLINE_STROKE = DrawContext.solidStroke(2);
    private static final Stroke HANDLE_STROKE = DrawContext.solidStroke(1.4);

    private SelectionPainter() {}

    /**
     * Returns the position of the handle that rotates an obstacle, pixels: above its centre at heading 0, and rotating
     * with it.
     */
    public static Vector2 handlePosition(Camera camera, Obstacle obstacle) {
        return stalkEnd(camera, obstacle.pose(), localBounds(obstacle), STALK_LENGTH);
    }

    /**
     * Returns the position of the handle that rotates several obstacles about their common centre, pixels: above all of
     * them; there is at least one.
     */
    public static Vector2 handlePosition(Camera camera, ObstacleGroup obstacles) {
        double top = obstacles.bounds().orElseThrow().getMaxY();
        Vector2 above = camera.toScreen(new Vector2(obstacles.centre().x(), top));
        return new Vector2(above.x(), above.y() - STALK_LENGTH);
    }

    private static Rectangle2D localBounds(Obstacle obstacle) {
        return ObstacleOutlines.localShape(obstacle.shape()).getBounds2D();
    }

    private static Vector2 stalkEnd(Camera camera, Pose pose, Rectangle2D bounds, double beyond) {
        double up = bounds.getHeight() / 2 * camera.scale() + beyond;
        Vector2 middle = camera.toScreen(pose.toParent(new Vector2(bounds.getCenterX(), bounds.getCenterY())));
        Vector2 direction = Vector2.direction(pose.heading()).perpendicular();
        return new Vector2(middle.x() + up * direction.x(), middle.y() - up * direction.y());
    }

    /** Paints the outline of a selected obstacle. */
    public static void paintOutline(DrawContext context, Obstacle obstacle) {
        context.draw(screenOutline(context, obstacle), context.palette().accent(), OUTLINE_STROKE);
    }

    /**
     * Paints the handles of the only selected obstacle, also those of its waypoints beside it; {@code places} are those
     * that change its size, metres.
     */
    public static void paintHandles(DrawContext context, Obstacle obstacle, List<Vector2> places) {
        // The bounds and the outline of a floor plan take long, so neither is computed twice or in vain.
        Rectangle2D bounds = localBounds(obstacle);
        paintHandle(
                context,
                stalkEnd(context.camera(), obstacle.pose(), bounds, 0),
                stalkEnd(context.camera(), obstacle.pose(), bounds, STALK_LENGTH));
        if (!obstacle.motion().waypoints().isEmpty()) {
            paintWaypoints(context, obstacle);
        }
        places.stream().map(context.camera()::toScreen).forEach(place -> paintSquareHandle(context, place));
    }

    private static void paintWaypoints(DrawContext context, Obstacle obstacle) {
        Shape outline = screenOutline(context, obstacle);
        List<Vector2> waypoints = obstacle.motion().waypoints().stream()
                .map(context.camera()::toScreen)
                .toList();
        List<Vector2> places = VisibleRoute.waypoints(
                        waypoints, context.camera().bounds())
                .stream()
                .filter(place -> !outline.contains(place.x(), place.y()))
                .toList();
        if (places.size() > VisibleRoute.MANY) {
            places.forEach(place -> paintSimpleKnob(context, place));
        } else {
            places.forEach(place -> paintKnob(context, Shapes.circle(place, WAYPOINT_RADIUS)));
        }
    }

    /** Paints a square of whole pixels in place of a circle, which takes much longer. */
    private static void paintSimpleKnob(DrawContext context, Vector2 place) {
        int x = (int) Math.floor(place.x());
        int y = (int) Math.floor(place.y());
        context.fill(new Rectangle(x - 3, y - 3, 7, 7), context.palette().accent());
        context.fill(new Rectangle(x - 2, y - 2, 5, 5), context.palette().canvas());
    }

    /** Paints the common handle of the selected obstacles, at least one. */
    public static void paintHandle(DrawContext context, ObstacleGroup obstacles) {
        paintHandle(
                context, context.camera().toScreen(obstacles.centre()), handlePosition(context.camera(), obstacles));
    }

    private static void paintHandle(DrawContext context, Vector2 foot, Vector2 handle) {
        context.draw(Shapes.polyline(List.of(foot, handle)), context.palette().accent(), HANDLE_STROKE);
        paintKnob(context, Shapes.circle(handle, HANDLE_RADIUS));
    }

    /** Paints a square handle at a position in the picture. */
    static void paintSquareHandle(DrawContext context, Vector2 place) {
        paintKnob(
                context,
                new Rectangle2D.Double(
                        place.x() - SQUARE_SIZE / 2, place.y() - SQUARE_SIZE / 2, SQUARE_SIZE, SQUARE_SIZE));
    }

    private static void paintKnob(DrawContext context, Shape knob) {
        context.fill(knob, context.palette().canvas());
        context.draw(knob, context.palette().accent(), HANDLE_STROKE);
    }

    /** Paints the outline of the selected sensor's cone, with handles on its arc and its edges. */
    public static void paintCone(DrawContext context, Sector sector) {
        ScreenSector cone = ScreenSector.of(context.camera(), sector);
        context.draw(cone.outline(), context.palette().accent(), OUTLINE_STROKE);
        paintSquareHandle(context, cone.pointAt(0.5, cone.radius()));
        paintSquareHandle(context, cone.pointAt(0, cone.radius() * EDGE_HANDLE_POSITION));
        paintSquareHandle(context, cone.pointAt(1, cone.radius() * EDGE_HANDLE_POSITION));
    }

    /** Returns the outline of an obstacle in the picture. */
    static Shape screenOutline(DrawContext context, Obstacle obstacle) {
        return context.toScreen(
                ObstacleOutlines.localShape(obstacle.shape()), RigidMotion.poseTransform(obstacle.pose()));
    }
}
