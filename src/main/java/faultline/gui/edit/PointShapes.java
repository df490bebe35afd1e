package faultline.gui.edit;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.List;

/** Obstacles of points that were drawn one by one. The origin of their frame is the middle of their bounds. */
public final class PointShapes {

    private PointShapes() {
    }

    /**
     * A closed polygon.
     *
     * @param id its id
     * @param points at least three, in the world, metres
     * @return the obstacle
     */
    public static Obstacle polygon(String id, List<Vec> points) {
        Pose frame = frame(points);
        return new Obstacle(id, new ObstacleShape.Polygon(local(points, frame)), frame);
    }

    /**
     * An open wall.
     *
     * @param id its id
     * @param points at least two, in the world, metres
     * @return the obstacle
     */
    public static Obstacle wall(String id, List<Vec> points) {
        Pose frame = frame(points);
        return new Obstacle(id, new ObstacleShape.Wall(local(points, frame)), frame);
    }

    private static Pose frame(List<Vec> points) {
        double left = points.stream().mapToDouble(Vec::x).min().orElseThrow();
        double right = points.stream().mapToDouble(Vec::x).max().orElseThrow();
        double low = points.stream().mapToDouble(Vec::y).min().orElseThrow();
        double high = points.stream().mapToDouble(Vec::y).max().orElseThrow();
        return new Pose(Metres.round((left + right) / 2), Metres.round((low + high) / 2), 0);
    }

    private static List<Vec> local(List<Vec> points, Pose frame) {
        return Metres.round(points.stream().map(frame::toLocal).toList());
    }
}
