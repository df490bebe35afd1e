package faultline.world;

import faultline.geometry.Convex;
import faultline.geometry.Disc;
import faultline.geometry.Oval;
import faultline.geometry.Pose;
import faultline.geometry.Segment;
import faultline.geometry.Vec;
import java.util.ArrayList;
import java.util.List;

/**
 * An obstacle's exact geometry in the world: the convex pieces of its outline, and its inside. The distance from any point outside it is
 * the distance to the nearest piece.
 *
 * @param parts the pieces, in the order of the shape's points
 * @param shape the obstacle's shape
 * @param pose the obstacle's pose
 */
public record Outline(List<Convex> parts, ObstacleShape shape, Pose pose) {

    /** Copies the list. */
    public Outline {
        parts = List.copyOf(parts);
    }

    /**
     * The geometry of an obstacle where it stands.
     *
     * @param obstacle the obstacle
     * @return its outline
     */
    public static Outline of(Obstacle obstacle) {
        return new Outline(parts(obstacle.shape(), obstacle.pose()), obstacle.shape(), obstacle.pose());
    }

    private static List<Convex> parts(ObstacleShape shape, Pose pose) {
        if (shape instanceof ObstacleShape.Circle circle) {
            return List.of(new Disc(pose.x(), pose.y(), circle.radius()));
        }
        if (shape instanceof ObstacleShape.Ellipse ellipse) {
            return List.of(Oval.at(pose, ellipse.rx(), ellipse.ry()));
        }
        if (shape instanceof ObstacleShape.Rectangle rectangle) {
            return chain(corners(rectangle), true, pose);
        }
        return shape instanceof ObstacleShape.Polygon polygon
                ? chain(polygon.points(), true, pose)
                : chain(((ObstacleShape.Wall) shape).points(), false, pose);
    }

    private static List<Vec> corners(ObstacleShape.Rectangle rectangle) {
        double x = rectangle.width() / 2;
        double y = rectangle.height() / 2;
        return List.of(new Vec(x, y), new Vec(-x, y), new Vec(-x, -y), new Vec(x, -y));
    }

    private static List<Convex> chain(List<Vec> points, boolean closed, Pose pose) {
        List<Vec> placed = points.stream().map(pose::toOuter).toList();
        List<Convex> sides = new ArrayList<>();
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
    public boolean contains(Vec point) {
        Vec local = pose.toLocal(point);
        if (shape instanceof ObstacleShape.Circle circle) {
            return local.length() <= circle.radius();
        }
        if (shape instanceof ObstacleShape.Ellipse ellipse) {
            return new Vec(local.x() / ellipse.rx(), local.y() / ellipse.ry()).length() <= 1;
        }
        if (shape instanceof ObstacleShape.Rectangle rectangle) {
            return Math.abs(local.x()) <= rectangle.width() / 2 && Math.abs(local.y()) <= rectangle.height() / 2;
        }
        return shape instanceof ObstacleShape.Polygon polygon && evenOdd(polygon.points(), local);
    }

    private static boolean evenOdd(List<Vec> points, Vec p) {
        boolean inside = false;
        Vec a = points.get(points.size() - 1);
        for (Vec b : points) {
            if (a.y() > p.y() != b.y() > p.y() && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
                inside = !inside;
            }
            a = b;
        }
        return inside;
    }
}
