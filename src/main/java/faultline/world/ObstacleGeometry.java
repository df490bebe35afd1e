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

    static ObstacleGeometry of(ObstacleShape shape, RigidMotion frame) {
        return new ObstacleGeometry(new Placement(frame, Vector2.ZERO, NO_LIMIT).partsOf(shape), shape, frame);
    }

    /**
     * Returns the geometry of an obstacle without those segments that are farther from a point than a distance. For a
     * floor plan it is created faster than the whole geometry.
     */
    static ObstacleGeometry near(Obstacle obstacle, Vector2 point, double distance) {
        RigidMotion frame = RigidMotion.of(obstacle.pose());
        // Rounding must not hide a segment that is just within the distance.
        Placement placement = new Placement(frame, frame.toLocal(point), distance + 1e-6);
        return new ObstacleGeometry(placement.partsOf(obstacle.shape()), obstacle.shape(), frame);
    }

    /**
     * {@return whether a point of the world is inside the obstacle; one on the outline may give either result}
     *
     * @param point the point, in metres
     */
    public boolean contains(Vector2 point) {
        return shape.contains(frame.toLocal(point));
    }

    /** The frame of a shape; of its segments, only those near a point of the shape's own frame are wanted. */
    private record Placement(RigidMotion frame, Vector2 centre, double reach) {

        List<ConvexShape> partsOf(ObstacleShape shape) {
            return shape.match(new ObstacleShape.ShapeCases<>(
                    rectangle -> segments(rectangle.corners(), true),
                    circle -> List.of(new Disc(frame.x(), frame.y(), circle.radius())),
                    ellipse -> List.of(new Ellipse(frame, ellipse.rx(), ellipse.ry())),
                    polygon -> segments(polygon.points(), true),
                    wall -> segments(wall.points(), false),
                    plan -> List.of(
                            reach < NO_LIMIT
                                    ? plan.points()
                                            .segments(frame, plan.points().sidesNear(centre, reach))
                                    : plan.points().segments(frame))));
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
