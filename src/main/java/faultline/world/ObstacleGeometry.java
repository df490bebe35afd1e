package faultline.world;

import faultline.geometry.ConvexShape;
import faultline.geometry.Disc;
import faultline.geometry.Ellipse;
import faultline.geometry.RigidMotion;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.List;

/**
 * An obstacle's exact geometry in the world: the convex parts of its outline, and its inside. The distance from any
 * point outside it is the distance to the nearest part.
 *
 * @param parts the parts, in the order of the shape's points
 * @param shape the obstacle's shape
 * @param frame the obstacle's frame
 */
public record ObstacleGeometry(List<ConvexShape> parts, ObstacleShape shape, RigidMotion frame) {

    private static final double NO_LIMIT = Double.POSITIVE_INFINITY;

    /**
     * Creates a geometry from a copy of the parts.
     *
     * @param parts the parts, in the order of the shape's points
     * @param shape the obstacle's shape
     * @param frame the obstacle's frame
     */
    public ObstacleGeometry {
        parts = List.copyOf(parts);
    }

    /**
     * {@return the geometry of an obstacle at its pose}
     *
     * @param obstacle the obstacle
     */
    public static ObstacleGeometry of(Obstacle obstacle) {
        return of(obstacle.shape(), RigidMotion.of(obstacle.pose()));
    }

    /** Returns the geometry of a shape in a frame. */
    static ObstacleGeometry of(ObstacleShape shape, RigidMotion frame) {
        return new ObstacleGeometry(shape.accept(new Placement(frame, Vector2.ZERO, NO_LIMIT)), shape, frame);
    }

    /**
     * Returns the geometry of an obstacle without those segments that are farther from a point than a distance, which
     * is made faster for a floor plan.
     */
    static ObstacleGeometry near(Obstacle obstacle, Vector2 point, double distance) {
        RigidMotion frame = RigidMotion.of(obstacle.pose());
        // Rounding must not hide a segment that just reaches.
        Placement placement = new Placement(frame, frame.toLocal(point), distance + 1e-6);
        return new ObstacleGeometry(obstacle.shape().accept(placement), obstacle.shape(), frame);
    }

    /**
     * {@return whether a point of the world is inside the obstacle; one on the outline may give either result}
     *
     * @param point the point, in metres
     */
    public boolean contains(Vector2 point) {
        return shape.contains(frame.toLocal(point));
    }

    /** Returns the parts of a shape in a frame; of segments, only those near a point of the shape's own frame. */
    private record Placement(RigidMotion frame, Vector2 centre, double reach)
            implements ObstacleShape.ShapeVisitor<List<ConvexShape>> {

        @Override
        public List<ConvexShape> visit(ObstacleShape.RectangleShape shape) {
            return segments(shape.corners(), true);
        }

        @Override
        public List<ConvexShape> visit(ObstacleShape.CircleShape shape) {
            return List.of(new Disc(frame.x(), frame.y(), shape.radius()));
        }

        @Override
        public List<ConvexShape> visit(ObstacleShape.EllipseShape shape) {
            return List.of(new Ellipse(frame, shape.rx(), shape.ry()));
        }

        @Override
        public List<ConvexShape> visit(ObstacleShape.PolygonShape shape) {
            return segments(shape.points(), true);
        }

        @Override
        public List<ConvexShape> visit(ObstacleShape.WallShape shape) {
            return segments(shape.points(), false);
        }

        @Override
        public List<ConvexShape> visit(ObstacleShape.PlanShape shape) {
            RingList points = shape.points();
            if (reach < NO_LIMIT) {
                return List.of(points.segments(frame, points.sidesNear(centre, reach)));
            }
            return List.of(points.segments(frame));
        }

        private List<ConvexShape> segments(List<Vector2> points, boolean closed) {
            return reach < NO_LIMIT ? nearSegments(points, closed) : allSegments(points, closed);
        }

        private List<ConvexShape> allSegments(List<Vector2> points, boolean closed) {
            // An array becomes an immutable list with one copy, an array list with three.
            ConvexShape[] segments = new ConvexShape[closed ? points.size() : points.size() - 1];
            Vector2 first = frame.toParent(points.get(0));
            Vector2 from = first;
            for (int i = 1; i < points.size(); i++) {
                Vector2 to = frame.toParent(points.get(i));
                segments[i - 1] = new Segment(from, to);
                from = to;
            }
            if (closed) {
                segments[segments.length - 1] = new Segment(from, first);
            }
            return List.of(segments);
        }

        private List<ConvexShape> nearSegments(List<Vector2> points, boolean closed) {
            List<ConvexShape> segments = new ArrayList<>();
            Vector2 from = points.get(closed ? points.size() - 1 : 0);
            for (int i = closed ? 0 : 1; i < points.size(); i++) {
                Vector2 to = points.get(i);
                if (isNear(from.x(), to.x(), centre.x()) && isNear(from.y(), to.y(), centre.y())) {
                    segments.add(new Segment(frame.toParent(from), frame.toParent(to)));
                }
                from = to;
            }
            return segments;
        }

        private boolean isNear(double from, double to, double middle) {
            return (from >= middle - reach || to >= middle - reach) && (from <= middle + reach || to <= middle + reach);
        }
    }
}
