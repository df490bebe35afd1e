package faultline.gui.edit;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.gui.text.Texts;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * The points by which a hand takes a shape to change its size: a rectangle's corners and sides, a curve's axes, all corners of what has
 * points.
 */
public final class ShapeHandles {

    private static final double LEAST = 0.01;
    /** Corners and middles of the sides of a rectangle, in halves of its size from its middle. */
    private static final List<Vec> SIDES = List.of(new Vec(1, 1), new Vec(0, 1), new Vec(-1, 1), new Vec(-1, 0), new Vec(-1, -1),
            new Vec(0, -1), new Vec(1, -1), new Vec(1, 0));
    private static final List<Vec> AXES = List.of(new Vec(1, 0), new Vec(-1, 0), new Vec(0, 1), new Vec(0, -1));

    private ShapeHandles() {
    }

    /**
     * Where the handles of an obstacle are.
     *
     * @param obstacle the obstacle
     * @return metres, in the world
     */
    public static List<Vec> places(Obstacle obstacle) {
        return local(obstacle.shape()).stream().map(obstacle.pose()::toOuter).toList();
    }

    private static List<Vec> local(ObstacleShape shape) {
        if (shape instanceof ObstacleShape.Rectangle box) {
            return SIDES.stream().map(side -> new Vec(side.x() * box.width() / 2, side.y() * box.height() / 2)).toList();
        }
        if (shape instanceof ObstacleShape.Circle circle) {
            return AXES.stream().map(axis -> axis.times(circle.radius())).toList();
        }
        if (shape instanceof ObstacleShape.Ellipse ellipse) {
            return AXES.stream().map(axis -> new Vec(axis.x() * ellipse.rx(), axis.y() * ellipse.ry())).toList();
        }
        return points(shape);
    }

    private static List<Vec> points(ObstacleShape shape) {
        return shape instanceof ObstacleShape.Polygon polygon ? polygon.points() : ((ObstacleShape.Wall) shape).points();
    }

    /**
     * An obstacle after one of its handles was dragged. Of a rectangle the opposite corner or side stays, of a circle or an ellipse the
     * middle, of all others every other corner.
     *
     * @param obstacle as it was
     * @param handle the place of the handle in {@link #places}
     * @param to where the hand is, metres
     * @param snap what it is rounded to
     * @return the obstacle of another shape
     */
    public static Obstacle dragged(Obstacle obstacle, int handle, Vec to, Snap snap) {
        Vec local = obstacle.pose().toLocal(to);
        ObstacleShape shape = obstacle.shape();
        if (shape instanceof ObstacleShape.Rectangle box) {
            return box(obstacle, box, SIDES.get(handle), local, snap);
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
        return corner(obstacle, handle, Metres.round(obstacle.pose().toLocal(snap.place(to))));
    }

    private static Obstacle box(Obstacle obstacle, ObstacleShape.Rectangle box, Vec side, Vec local, Snap snap) {
        double w = side.x() == 0 ? box.width() : size(side.x() * local.x() + box.width() / 2, snap);
        double h = side.y() == 0 ? box.height() : size(side.y() * local.y() + box.height() / 2, snap);
        Vec middle = obstacle.pose().toOuter(new Vec(side.x() * (w - box.width()) / 2, side.y() * (h - box.height()) / 2));
        Vec place = Metres.round(middle);
        return with(obstacle, new ObstacleShape.Rectangle(w, h), new Pose(place.x(), place.y(), obstacle.pose().heading()));
    }

    private static double size(double free, Snap snap) {
        return Metres.round(Math.max(LEAST, snap.length(free)));
    }

    private static Obstacle corner(Obstacle obstacle, int corner, Vec to) {
        List<Vec> points = new ArrayList<>(points(obstacle.shape()));
        points.set(corner, to);
        boolean closed = obstacle.shape() instanceof ObstacleShape.Polygon;
        return with(obstacle, closed ? new ObstacleShape.Polygon(points) : new ObstacleShape.Wall(points), obstacle.pose());
    }

    private static Obstacle with(Obstacle obstacle, ObstacleShape shape, Pose pose) {
        return obstacle.shaped(shape).at(pose);
    }

    /**
     * The size of an obstacle in words.
     *
     * @param obstacle the obstacle
     * @param handle the handle that changes it, by its place in {@link #places}
     * @return for people
     */
    public static String values(Obstacle obstacle, int handle) {
        ObstacleShape shape = obstacle.shape();
        if (shape instanceof ObstacleShape.Rectangle box) {
            return Texts.text("value.size", metres(box.width()), metres(box.height()));
        }
        if (shape instanceof ObstacleShape.Circle circle) {
            return Texts.text("value.radius", metres(circle.radius()));
        }
        if (shape instanceof ObstacleShape.Ellipse ellipse) {
            return Texts.text("value.axes", metres(ellipse.rx()), metres(ellipse.ry()));
        }
        Vec place = places(obstacle).get(handle);
        return Texts.text("value.place", metres(place.x()), metres(place.y()));
    }

    /**
     * A length as it stands beside a hand.
     *
     * @param value metres
     * @return three digits behind the point
     */
    public static String metres(double value) {
        return String.format(Locale.ROOT, "%.3f", value);
    }
}
