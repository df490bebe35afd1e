package faultline.gui.edit;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.List;

/** Obstacles of points that were drawn one by one. The origin of their frame is the middle of their bounds. */
public final class PointShapes {

    private PointShapes() {}

    /**
     * A closed polygon.
     *
     * @param id its id
     * @param points at least three, in the world, metres
     * @return the obstacle
     */
    public static Obstacle polygon(String id, List<Vector2> points) {
        Pose frame = frame(points);
        return new Obstacle(id, new ObstacleShape.Polygon(toLocal(points, frame)), frame);
    }

    /**
     * An open wall.
     *
     * @param id its id
     * @param points at least two, in the world, metres
     * @return the obstacle
     */
    public static Obstacle wall(String id, List<Vector2> points) {
        Pose frame = frame(points);
        return new Obstacle(id, new ObstacleShape.Wall(toLocal(points, frame)), frame);
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
