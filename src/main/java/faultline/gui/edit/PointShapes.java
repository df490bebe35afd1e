package faultline.gui.edit;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;

/** Creates obstacles from points. The origin of their frame is the centre of their bounds. */
public final class PointShapes {

    /** Points that are nearer to a line count as on it, metres. */
    private static final double ON_LINE = 1e-6;

    private PointShapes() {}

    /**
     * Returns whether all points are on one line, so that a polygon has no area. A file may have such a polygon, which
     * is like a wall.
     */
    public static boolean areOnOneLine(List<Vector2> points) {
        Vector2 first = points.get(0);
        Vector2 farthest = Collections.max(points, Comparator.comparingDouble(first::distanceTo))
                .minus(first);
        return points.stream()
                .allMatch(point -> Math.abs(farthest.cross(point.minus(first))) <= ON_LINE * farthest.length());
    }

    /** Returns a closed polygon of at least three points in the world, metres. */
    public static Obstacle polygon(String id, List<Vector2> points) {
        Pose frame = frame(points);
        return new Obstacle(id, new ObstacleShape.PolygonShape(toLocal(points, frame)), frame);
    }

    /** Returns an open wall of at least two points in the world, metres. */
    public static Obstacle wall(String id, List<Vector2> points) {
        Pose frame = frame(points);
        return new Obstacle(id, new ObstacleShape.WallShape(toLocal(points, frame)), frame);
    }

    private static Pose frame(List<Vector2> points) {
        double left = points.stream().mapToDouble(Vector2::x).min().orElseThrow();
        double right = points.stream().mapToDouble(Vector2::x).max().orElseThrow();
        double low = points.stream().mapToDouble(Vector2::y).min().orElseThrow();
        double high = points.stream().mapToDouble(Vector2::y).max().orElseThrow();
        return new Pose(Rounding.round((left + right) / 2), Rounding.round((low + high) / 2), 0);
    }

    private static List<Vector2> toLocal(List<Vector2> points, Pose frame) {
        return Rounding.round(points.stream().map(frame::toLocal).toList());
    }
}
