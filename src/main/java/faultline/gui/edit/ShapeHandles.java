package faultline.gui.edit;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.text.Messages;
import faultline.io.DecimalText;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/**
 * The handles by which a drag changes a shape: the corners and sides of a rectangle, the axes of a circle or an
 * ellipse, all points of other shapes.
 */
public final class ShapeHandles {

    /** The minimum width and height of a shape, metres. */
    private static final double MIN_SIZE = 0.01;
    /** The corners and the midpoints of the sides of a rectangle, in half its size from its centre. */
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

    /** Returns the positions of the handles of an obstacle, metres in the world. */
    public static List<Vector2> positions(Obstacle obstacle) {
        return localPositions(obstacle.shape()).stream()
                .map(obstacle.pose()::toParent)
                .toList();
    }

    private static List<Vector2> localPositions(ObstacleShape shape) {
        return shape.match(HANDLES).positions();
    }

    /**
     * Returns an obstacle after the handle with an index in {@link #positions} was dragged to a point, metres. The
     * opposite corner or side of a rectangle, the centre of a circle or an ellipse, and all other points of other
     * shapes stay in place.
     */
    public static Obstacle dragHandle(Obstacle obstacle, int handle, Vector2 to, SnapSettings snap) {
        return obstacle.shape().match(HANDLES).drag(obstacle, handle, to, snap);
    }

    private static double size(double free, SnapSettings snap) {
        return Rounding.round(Math.max(MIN_SIZE, snap.length(free)));
    }

    private static Obstacle with(Obstacle obstacle, ObstacleShape shape, Pose pose) {
        return obstacle.withShape(shape).withPose(pose);
    }

    /** Returns the size that a handle changes, in the user's language. */
    public static String sizeText(Obstacle obstacle, int handle) {
        return obstacle.shape().match(HANDLES).sizeText(obstacle, handle);
    }

    /** Returns a length in metres with three decimals. */
    public static String formatMetres(double value) {
        return DecimalText.formatFixed(value, 3);
    }

    /** The handles of one kind of shape. */
    private interface Handles {

        /** Returns the positions of the handles in the shape's frame. */
        List<Vector2> positions();

        /** Returns an obstacle of this shape after a handle was dragged to a point of the world. */
        Obstacle drag(Obstacle obstacle, int handle, Vector2 to, SnapSettings snap);

        /** Returns the size of an obstacle of this shape as a text. */
        String sizeText(Obstacle obstacle, int handle);
    }

    private static final ObstacleShape.ShapeCases<Handles> HANDLES = new ObstacleShape.ShapeCases<>(
            RectangleHandles::new,
            CircleHandles::new,
            EllipseHandles::new,
            polygon -> new CornerHandles(polygon.points(), ObstacleShape.PolygonShape::new),
            wall -> new CornerHandles(wall.points(), ObstacleShape.WallShape::new),
            // A plan is moved and rotated as a whole; its thousands of corners have no handles.
            plan -> new CornerHandles(List.of(), points -> plan));

    private record RectangleHandles(ObstacleShape.RectangleShape shape) implements Handles {
        @Override
        public List<Vector2> positions() {
            return SIDES.stream()
                    .map(side -> new Vector2(side.x() * shape.width() / 2, side.y() * shape.height() / 2))
                    .toList();
        }

        @Override
        public Obstacle drag(Obstacle obstacle, int handle, Vector2 to, SnapSettings snap) {
            Vector2 local = obstacle.pose().toLocal(to);
            Vector2 side = SIDES.get(handle);
            double w = side.x() == 0 ? shape.width() : size(side.x() * local.x() + shape.width() / 2, snap);
            double h = side.y() == 0 ? shape.height() : size(side.y() * local.y() + shape.height() / 2, snap);
            Vector2 middle = obstacle.pose()
                    .toParent(new Vector2(side.x() * (w - shape.width()) / 2, side.y() * (h - shape.height()) / 2));
            return with(
                    obstacle,
                    new ObstacleShape.RectangleShape(w, h),
                    // Rounded finely, so that the opposite side of a rotated rectangle stays in place.
                    obstacle.pose()
                            .withPosition(Rounding.roundFinely(obstacle.pose().position(), middle)));
        }

        @Override
        public String sizeText(Obstacle obstacle, int handle) {
            return Messages.get("value.size", formatMetres(shape.width()), formatMetres(shape.height()));
        }
    }

    private record CircleHandles(ObstacleShape.CircleShape shape) implements Handles {
        @Override
        public List<Vector2> positions() {
            return AXES.stream().map(axis -> axis.times(shape.radius())).toList();
        }

        @Override
        public Obstacle drag(Obstacle obstacle, int handle, Vector2 to, SnapSettings snap) {
            double radius = size(obstacle.pose().toLocal(to).length(), snap);
            return obstacle.withShape(new ObstacleShape.CircleShape(radius));
        }

        @Override
        public String sizeText(Obstacle obstacle, int handle) {
            return Messages.get("value.radius", formatMetres(shape.radius()));
        }
    }

    private record EllipseHandles(ObstacleShape.EllipseShape shape) implements Handles {
        @Override
        public List<Vector2> positions() {
            return AXES.stream()
                    .map(axis -> new Vector2(axis.x() * shape.rx(), axis.y() * shape.ry()))
                    .toList();
        }

        @Override
        public Obstacle drag(Obstacle obstacle, int handle, Vector2 to, SnapSettings snap) {
            Vector2 local = obstacle.pose().toLocal(to);
            boolean alongX = AXES.get(handle).y() == 0;
            double rx = alongX ? size(Math.abs(local.x()), snap) : shape.rx();
            double ry = alongX ? shape.ry() : size(Math.abs(local.y()), snap);
            return obstacle.withShape(new ObstacleShape.EllipseShape(rx, ry));
        }

        @Override
        public String sizeText(Obstacle obstacle, int handle) {
            return Messages.get("value.axes", formatMetres(shape.rx()), formatMetres(shape.ry()));
        }
    }

    /** One handle at each point of a polygon or a wall. */
    private record CornerHandles(List<Vector2> positions, Function<List<Vector2>, ObstacleShape> factory)
            implements Handles {
        @Override
        public Obstacle drag(Obstacle obstacle, int handle, Vector2 to, SnapSettings snap) {
            List<Vector2> points = new ArrayList<>(positions);
            points.set(handle, Rounding.round(obstacle.pose().toLocal(snap.point(to))));
            return obstacle.withShape(factory.apply(points));
        }

        @Override
        public String sizeText(Obstacle obstacle, int handle) {
            Vector2 place = obstacle.pose().toParent(positions.get(handle));
            return Messages.get("value.place", formatMetres(place.x()), formatMetres(place.y()));
        }
    }
}
