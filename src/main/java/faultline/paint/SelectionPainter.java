package faultline.paint;

import faultline.geometry.RigidMotion;
import faultline.geometry.Sector;
import faultline.geometry.Vec;
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

    private static final double SQUARE = 7;
    /** How far along a cone's edge its handle is. */
    private static final double EDGE_HANDLE = 0.75;
    private static final double HANDLE_STALK = 24;
    private static final Stroke OUTLINE = Brush.solid(2);
    private static final Stroke KNOB = Brush.solid(1.4);

    private SelectionPainter() {
    }

    /**
     * Where the handle that turns an obstacle is: above its middle while its heading is 0, and turning with it.
     *
     * @param camera from the world to the picture
     * @param obstacle the obstacle
     * @return pixels
     */
    public static Vec handle(Camera camera, Obstacle obstacle) {
        return stalk(camera, obstacle, HANDLE_STALK);
    }

    /**
     * Where the handle that turns several obstacles about their common middle is: above all of them.
     *
     * @param camera from the world to the picture
     * @param obstacles the obstacles, at least one
     * @return pixels
     */
    public static Vec handle(Camera camera, List<Obstacle> obstacles) {
        double top = obstacles.stream().mapToDouble(obstacle -> ObstacleOutlines.inWorld(obstacle).getBounds2D().getMaxY()).max().orElseThrow();
        Vec above = camera.toScreen(new Vec(ObstacleOutlines.middle(obstacles).x(), top));
        return new Vec(above.x(), above.y() - HANDLE_STALK);
    }

    private static Vec stalk(Camera camera, Obstacle obstacle, double beyond) {
        Rectangle2D bounds = ObstacleOutlines.local(obstacle.shape()).getBounds2D();
        double up = bounds.getHeight() / 2 * camera.scale() + beyond;
        Vec middle = camera.toScreen(ObstacleOutlines.middle(obstacle));
        Vec direction = Vec.direction(obstacle.pose().heading()).perpendicular();
        return new Vec(middle.x() + up * direction.x(), middle.y() - up * direction.y());
    }

    /**
     * Paints the outline of a selected obstacle.
     *
     * @param brush where to
     * @param obstacle the obstacle as it stands
     */
    public static void paintOutline(Brush brush, Obstacle obstacle) {
        brush.draw(outline(brush, obstacle), brush.palette().accent(), OUTLINE);
    }

    /**
     * Paints the handles of the only selected obstacle.
     *
     * @param brush where to
     * @param obstacle the obstacle as it stands
     * @param places of the handles that change its size, metres
     */
    public static void paintHandles(Brush brush, Obstacle obstacle, List<Vec> places) {
        paintHandle(brush, stalk(brush.camera(), obstacle, 0), handle(brush.camera(), obstacle));
        places.stream().map(brush.camera()::toScreen).forEach(place -> square(brush, place));
    }

    /**
     * Paints the handle of several selected obstacles.
     *
     * @param brush where to
     * @param obstacles the obstacles as they stand, at least one
     */
    public static void paintHandle(Brush brush, List<Obstacle> obstacles) {
        paintHandle(brush, brush.camera().toScreen(ObstacleOutlines.middle(obstacles)), handle(brush.camera(), obstacles));
    }

    private static void paintHandle(Brush brush, Vec foot, Vec handle) {
        brush.draw(new Line2D.Double(foot.x(), foot.y(), handle.x(), handle.y()), brush.palette().accent(), KNOB);
        knob(brush, new Ellipse2D.Double(handle.x() - HANDLE_RADIUS, handle.y() - HANDLE_RADIUS, 2 * HANDLE_RADIUS, 2 * HANDLE_RADIUS));
    }

    /** A square about a place of the picture. */
    static void square(Brush brush, Vec place) {
        knob(brush, new Rectangle2D.Double(place.x() - SQUARE / 2, place.y() - SQUARE / 2, SQUARE, SQUARE));
    }

    private static void knob(Brush brush, Shape knob) {
        brush.fill(knob, brush.palette().canvas());
        brush.draw(knob, brush.palette().accent(), KNOB);
    }

    /**
     * Paints the outline of the selected sensor's cone, with handles on its rim and its edges.
     *
     * @param brush where to
     * @param sector the cone
     */
    public static void paintCone(Brush brush, Sector sector) {
        ScreenSector cone = ScreenSector.of(brush.camera(), sector);
        brush.draw(cone.outline(), brush.palette().accent(), OUTLINE);
        square(brush, cone.at(0.5, cone.radius()));
        square(brush, cone.at(0, cone.radius() * EDGE_HANDLE));
        square(brush, cone.at(1, cone.radius() * EDGE_HANDLE));
    }

    /** The outline of an obstacle in the picture. */
    static Shape outline(Brush brush, Obstacle obstacle) {
        return brush.onScreen(ObstacleOutlines.local(obstacle.shape()), RigidMotion.to(obstacle.pose()));
    }
}
