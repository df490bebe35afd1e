package faultline.world;

import faultline.geometry.ConvexShape;
import faultline.geometry.Disc;
import faultline.geometry.Ellipse;
import faultline.geometry.Pose;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.List;

/**
 * An obstacle's exact geometry in the world: the convex pieces of its outline, and its inside. The distance from any
 * point outside it is the distance to the nearest piece.
 *
 * @param parts the pieces, in the order of the shape's points
 * @param shape the obstacle's shape
 * @param pose the obstacle's pose
 */
public record ObstacleGeometry(List<ConvexShape> parts, ObstacleShape shape, Pose pose) {

    /** Copies the list. */
    public ObstacleGeometry {
        parts = List.copyOf(parts);
    }

    /**
     * The geometry of an obstacle where it stands.
     *
     * @param obstacle the obstacle
     * @return its outline
     */
    public static ObstacleGeometry of(Obstacle obstacle) {
        return new ObstacleGeometry(parts(obstacle.shape(), obstacle.pose()), obstacle.shape(), obstacle.pose());
    }

    private static List<ConvexShape> parts(ObstacleShape shape, Pose pose) {
        if (shape instanceof ObstacleShape.Circle circle) {
            return List.of(new Disc(pose.x(), pose.y(), circle.radius()));
        }
        if (shape instanceof ObstacleShape.Ellipse ellipse) {
            return List.of(Ellipse.at(pose, ellipse.rx(), ellipse.ry()));
        }
        if (shape instanceof ObstacleShape.Rectangle rectangle) {
            return segments(corners(rectangle), true, pose);
        }
        return shape instanceof ObstacleShape.Polygon polygon
                ? segments(polygon.points(), true, pose)
                : segments(((ObstacleShape.Wall) shape).points(), false, pose);
    }

    private static List<Vector2> corners(ObstacleShape.Rectangle rectangle) {
        double x = rectangle.width() / 2;
        double y = rectangle.height() / 2;
        return List.of(new Vector2(x, y), new Vector2(-x, y), new Vector2(-x, -y), new Vector2(x, -y));
    }

    private static List<ConvexShape> segments(List<Vector2> points, boolean closed, Pose pose) {
        List<Vector2> placed = points.stream().map(pose::toParent).toList();
        List<ConvexShape> sides = new ArrayList<>();
        for (int i = 1; i < placed.size(); i++) {
            sides.add(new Segment(placed.get(i - 1), placed.get(i)));
        }
        if (closed) {
            sides.add(new Segment(placed.get(placed.size() - 1), placed.get(0)));
        }
        return sides;
    }

    /**
     * Whether a point lies inside the obstacle. A wall has no inside.
     *
     * @param point in the world
     * @return true for a point inside; a point on the very outline may give either
     */
    public boolean contains(Vector2 point) {
        Vector2 local = pose.toLocal(point);
        if (shape instanceof ObstacleShape.Circle circle) {
            return local.length() <= circle.radius();
        }
        if (shape instanceof ObstacleShape.Ellipse ellipse) {
            return new Vector2(local.x() / ellipse.rx(), local.y() / ellipse.ry()).length() <= 1;
        }
        if (shape instanceof ObstacleShape.Rectangle rectangle) {
            return Math.abs(local.x()) <= rectangle.width() / 2 && Math.abs(local.y()) <= rectangle.height() / 2;
        }
        return shape instanceof ObstacleShape.Polygon polygon && containsEvenOdd(polygon.points(), local);
    }

    private static boolean containsEvenOdd(List<Vector2> points, Vector2 p) {
        boolean inside = false;
        Vector2 a = points.get(points.size() - 1);
        for (Vector2 b : points) {
            if (a.y() > p.y() != b.y() > p.y() && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
                inside = !inside;
            }
            a = b;
        }
        return inside;
    }
}
