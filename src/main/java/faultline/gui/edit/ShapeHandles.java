package faultline.gui.edit;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.text.Messages;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * The points by which a hand takes a shape to change its size: a rectangle's corners and sides, a curve's axes, all
 * corners of what has points.
 */
public final class ShapeHandles {

    private static final double MIN_SIZE = 0.01;
    /** Corners and middles of the sides of a rectangle, in halves of its size from its middle. */
    private static final List<Vector2> SIDES = List.of(
            new Vector2(1, 1),
            new Vector2(0, 1),
            new Vector2(-1, 1),
            new Vector2(-1, 0),
            new Vector2(-1, -1),
            new Vector2(0, -1),
            new Vector2(1, -1),
            new Vector2(1, 0));

    private static final List<Vector2> AXES =
            List.of(new Vector2(1, 0), new Vector2(-1, 0), new Vector2(0, 1), new Vector2(0, -1));

    private ShapeHandles() {}

    /**
     * Where the handles of an obstacle are.
     *
     * @param obstacle the obstacle
     * @return metres, in the world
     */
    public static List<Vector2> positions(Obstacle obstacle) {
        return localPositions(obstacle.shape()).stream()
                .map(obstacle.pose()::toParent)
                .toList();
    }

    private static List<Vector2> localPositions(ObstacleShape shape) {
        if (shape instanceof ObstacleShape.Rectangle box) {
            return SIDES.stream()
                    .map(side -> new Vector2(side.x() * box.width() / 2, side.y() * box.height() / 2))
                    .toList();
        }
        if (shape instanceof ObstacleShape.Circle circle) {
            return AXES.stream().map(axis -> axis.times(circle.radius())).toList();
        }
        if (shape instanceof ObstacleShape.Ellipse ellipse) {
            return AXES.stream()
                    .map(axis -> new Vector2(axis.x() * ellipse.rx(), axis.y() * ellipse.ry()))
                    .toList();
        }
        return points(shape);
    }

    private static List<Vector2> points(ObstacleShape shape) {
        return shape instanceof ObstacleShape.Polygon polygon
                ? polygon.points()
                : ((ObstacleShape.Wall) shape).points();
    }

    /**
     * An obstacle after one of its handles was dragged. Of a rectangle the opposite corner or side stays, of a circle
     * or an ellipse the middle, of all others every other corner.
     *
     * @param obstacle as it was
     * @param handle the place of the handle in {@link #positions}
     * @param to where the hand is, metres
     * @param snap what it is rounded to
     * @return the obstacle of another shape
     */
    public static Obstacle dragHandle(Obstacle obstacle, int handle, Vector2 to, SnapSettings snap) {
        Vector2 local = obstacle.pose().toLocal(to);
        ObstacleShape shape = obstacle.shape();
        if (shape instanceof ObstacleShape.Rectangle box) {
            return resizeRectangle(obstacle, box, SIDES.get(handle), local, snap);
        }
        if (shape instanceof ObstacleShape.Circle) {
            return with(obstacle, new ObstacleShape.Circle(size(local.length(), snap)), obstacle.pose());
        }
        if (shape instanceof ObstacleShape.Ellipse ellipse) {
            boolean across = AXES.get(handle).y() == 0;
            double rx = across ? size(Math.abs(local.x()), snap) : ellipse.rx();
            double ry = across ? ellipse.ry() : size(Math.abs(local.y()), snap);
            return with(obstacle, new ObstacleShape.Ellipse(rx, ry), obstacle.pose());
        }
        return moveCorner(obstacle, handle, Rounding.round(obstacle.pose().toLocal(snap.point(to))));
    }

    private static Obstacle resizeRectangle(
            Obstacle obstacle, ObstacleShape.Rectangle box, Vector2 side, Vector2 local, SnapSettings snap) {
        double w = side.x() == 0 ? box.width() : size(side.x() * local.x() + box.width() / 2, snap);
        double h = side.y() == 0 ? box.height() : size(side.y() * local.y() + box.height() / 2, snap);
        Vector2 middle = obstacle.pose()
                .toParent(new Vector2(side.x() * (w - box.width()) / 2, side.y() * (h - box.height()) / 2));
        Vector2 place = Rounding.round(middle);
        return with(
                obstacle,
                new ObstacleShape.Rectangle(w, h),
                new Pose(place.x(), place.y(), obstacle.pose().heading()));
    }

    private static double size(double free, SnapSettings snap) {
        return Rounding.round(Math.max(MIN_SIZE, snap.length(free)));
    }

    private static Obstacle moveCorner(Obstacle obstacle, int corner, Vector2 to) {
        List<Vector2> points = new ArrayList<>(points(obstacle.shape()));
        points.set(corner, to);
        boolean closed = obstacle.shape() instanceof ObstacleShape.Polygon;
        return with(
                obstacle, closed ? new ObstacleShape.Polygon(points) : new ObstacleShape.Wall(points), obstacle.pose());
    }

    private static Obstacle with(Obstacle obstacle, ObstacleShape shape, Pose pose) {
        return obstacle.withShape(shape).withPose(pose);
    }

    /**
     * The size of an obstacle in words.
     *
     * @param obstacle the obstacle
     * @param handle the handle that changes it, by its place in {@link #positions}
     * @return for people
     */
    public static String sizeText(Obstacle obstacle, int handle) {
        ObstacleShape shape = obstacle.shape();
        if (shape instanceof ObstacleShape.Rectangle box) {
            return Messages.get("value.size", formatMetres(box.width()), formatMetres(box.height()));
        }
        if (shape instanceof ObstacleShape.Circle circle) {
            return Messages.get("value.radius", formatMetres(circle.radius()));
        }
        if (shape instanceof ObstacleShape.Ellipse ellipse) {
            return Messages.get("value.axes", formatMetres(ellipse.rx()), formatMetres(ellipse.ry()));
        }
        Vector2 place = positions(obstacle).get(handle);
        return Messages.get("value.place", formatMetres(place.x()), formatMetres(place.y()));
    }

    /**
     * A length as it stands beside a hand.
     *
     * @param value metres
     * @return three digits behind the point
     */
    public static String formatMetres(double value) {
        return String.format(Locale.ROOT, "%.3f", value);
    }
}
