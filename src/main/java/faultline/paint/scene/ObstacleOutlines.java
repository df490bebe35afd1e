package faultline.paint.scene;

import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;
import faultline.geometry.Vector2;
import faultline.paint.surface.Shapes;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RectangularShape;
import java.util.Collection;
import java.util.List;

/** Converts obstacles to shapes of {@link java.awt.geom}, in metres. */
public final class ObstacleOutlines {

    private static final ObstacleShape.ShapeCases<Shape> OUTLINE = new ObstacleShape.ShapeCases<>(
            rectangle -> centred(new Rectangle2D.Double(), rectangle.width(), rectangle.height()),
            circle -> centred(new Ellipse2D.Double(), 2 * circle.radius(), 2 * circle.radius()),
            ellipse -> centred(new Ellipse2D.Double(), 2 * ellipse.rx(), 2 * ellipse.ry()),
            polygon -> {
                Path2D path = polyline(polygon.points());
                path.closePath();
                return path;
            },
            wall -> polyline(wall.points()),
            plan -> {
                // A floor plan may have tens of thousands of points, so the path has room for all from the start.
                int segments = plan.pointCount() + plan.rings().size();
                Path2D path = new Path2D.Double(Path2D.WIND_EVEN_ODD, segments);
                plan.rings().forEach(ring -> Shapes.appendPolygon(path, ring));
                return path;
            });

    private static final ObstacleShape.ShapeCases<Integer> CORNER_COUNT = new ObstacleShape.ShapeCases<>(
            rectangle -> 4,
            circle -> 0,
            ellipse -> 0,
            polygon -> polygon.points().size(),
            wall -> wall.points().size(),
            ObstacleShape.PlanShape::pointCount);

    private ObstacleOutlines() {}

    /** Returns the outline of a shape in its own frame; open for a wall, closed for all others. */
    public static Shape localShape(ObstacleShape shape) {
        return shape.match(OUTLINE);
    }

    /** Returns the number of corners of an outline. */
    public static int cornerCount(ObstacleShape shape) {
        return shape.match(CORNER_COUNT);
    }

    private static Shape centred(RectangularShape shape, double width, double height) {
        shape.setFrame(-width / 2, -height / 2, width, height);
        return shape;
    }

    /** Returns an open path with the even-odd rule, by which the world fills polygons. */
    private static Path2D polyline(List<Vector2> points) {
        Path2D path = Shapes.polyline(points);
        path.setWindingRule(Path2D.WIND_EVEN_ODD);
        return path;
    }

    public static Shape worldShape(Obstacle obstacle) {
        return RigidMotion.poseTransform(obstacle.pose()).createTransformedShape(localShape(obstacle.shape()));
    }

    /**
     * Returns the centre of an obstacle in the world, metres, about which the user rotates it. The origin of a
     * polygon's frame may lie far outside.
     */
    public static Vector2 centre(Obstacle obstacle) {
        return obstacle.pose().toParent(localCentre(obstacle));
    }

    /**
     * Returns the common centre of obstacles, metres, about which the user rotates them: the mean of their centres,
     * which a rotation does not move.
     */
    public static Vector2 centre(Collection<Obstacle> obstacles) {
        return obstacles.stream()
                .map(ObstacleOutlines::centre)
                .reduce(Vector2.ZERO, Vector2::plus)
                .times(1.0 / obstacles.size());
    }

    private static Vector2 localCentre(Obstacle obstacle) {
        return middle(localShape(obstacle.shape()));
    }

    /** Returns the middle of the bounds of a shape. */
    static Vector2 middle(Shape shape) {
        Rectangle2D bounds = shape.getBounds2D();
        return new Vector2(bounds.getCenterX(), bounds.getCenterY());
    }

    /**
     * Returns the pose of an obstacle after a rotation about a point of the world by an angle, radians, counter-
     * clockwise: eq. (1).
     */
    public static Pose rotatedPose(Obstacle obstacle, Vector2 about, double turn) {
        Pose pose = obstacle.pose();
        Vector2 origin = RigidMotion.rotationAbout(about, turn).toParent(pose.position());
        return new Pose(origin.x(), origin.y(), pose.heading() + turn);
    }
}
