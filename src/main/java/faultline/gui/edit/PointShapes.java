package faultline.gui.edit;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.List;

/** Creates obstacles from points. The origin of their frame is the centre of their bounds. */
public final class PointShapes {

    private PointShapes() {}

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
