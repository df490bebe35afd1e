package faultline.gui.canvas.tool;

import faultline.geometry.RigidMotion;
import faultline.geometry.Vector2;
import faultline.paint.scene.Layer;
import faultline.paint.scene.ObstacleOutlines;
import faultline.paint.surface.Camera;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.Shape;
import java.awt.geom.Line2D;
import java.util.List;
import java.util.Optional;

/** Finds the obstacle under the mouse, or whose waypoint is there, with a tolerance for thin poles and walls. */
public final class ObstacleFinder {

    /** The largest distance between an obstacle and the mouse, pixels. */
    private static final double TOLERANCE = 5;

    private ObstacleFinder() {}

    /** Returns the topmost obstacle at a position on the canvas; moving obstacles are painted after still ones. */
    public static Optional<Obstacle> topmostAt(Camera camera, List<Obstacle> obstacles, Vector2 screen) {
        Vector2 point = camera.toWorld(screen);
        double tolerance = TOLERANCE / camera.scale();
        List<Obstacle> under = obstacles.stream()
                .filter(obstacle -> touches(obstacle, point, tolerance))
                .toList();
        Optional<Obstacle> moving =
                under.stream().filter(obstacle -> obstacle.isMoving()).reduce((lower, upper) -> upper);
        return moving.or(() -> under.stream().reduce((lower, upper) -> upper));
    }

    /** Returns the topmost obstacle that has a visible waypoint at a position on the canvas. */
    static Optional<Obstacle> ofWaypointAt(CanvasModel model, Camera camera, Vector2 screen) {
        return model.obstacles().stream()
                .filter(obstacle -> obstacle.isMoving())
                .filter(obstacle -> model.layers().contains(Layer.ROUTES) || model.isSelected(obstacle))
                .filter(obstacle -> obstacle.motion().waypoints().stream()
                        .anyMatch(point -> camera.toScreen(point).distanceTo(screen) <= TOLERANCE))
                .reduce((lower, upper) -> upper);
    }

    private static boolean touches(Obstacle obstacle, Vector2 point, double tolerance) {
        if (obstacle.shape() instanceof ObstacleShape.WallShape wall) {
            return touches(wall.points(), RigidMotion.of(obstacle.pose()), point, tolerance);
        }
        Shape shape = ObstacleOutlines.worldShape(obstacle);
        return shape.intersects(point.x() - tolerance, point.y() - tolerance, 2 * tolerance, 2 * tolerance);
    }

    private static boolean touches(List<Vector2> points, RigidMotion frame, Vector2 point, double tolerance) {
        for (int i = 1; i < points.size(); i++) {
            Vector2 from = frame.toParent(points.get(i - 1));
            Vector2 to = frame.toParent(points.get(i));
            if (Line2D.ptSegDist(from.x(), from.y(), to.x(), to.y(), point.x(), point.y()) <= tolerance) {
                return true;
            }
        }
        return false;
    }
}
