package faultline.paint.surface;

import faultline.geometry.Vector2;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.util.List;

/** Creates shapes from points. All coordinates are in pixels. */
public final class Shapes {

    private Shapes() {}

    /** Returns the open line through points, at least one. */
    public static Path2D polyline(List<Vector2> points) {
        Path2D path = new Path2D.Double(Path2D.WIND_NON_ZERO, points.size() + 1);
        appendPolyline(path, points);
        return path;
    }

    private static void appendPolyline(Path2D path, List<Vector2> points) {
        path.moveTo(points.get(0).x(), points.get(0).y());
        for (int i = 1; i < points.size(); i++) {
            path.lineTo(points.get(i).x(), points.get(i).y());
        }
    }

    /** Appends the closed line through points, at least one, to a path. */
    public static void appendPolygon(Path2D path, List<Vector2> points) {
        appendPolyline(path, points);
        path.closePath();
    }

    /** Returns the closed line through points, at least one. */
    public static Path2D polygon(List<Vector2> points) {
        Path2D path = polyline(points);
        path.closePath();
        return path;
    }

    public static Ellipse2D circle(Vector2 centre, double radius) {
        return new Ellipse2D.Double(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius);
    }

    /** Returns the head of an arrow, a triangle; the direction is a unit vector, the width that of the base. */
    public static Path2D arrowhead(Vector2 tip, Vector2 direction, double length, double width) {
        Vector2 base = tip.minus(direction.times(length));
        Vector2 half = direction.perpendicular().times(width / 2);
        return polygon(List.of(tip, base.plus(half), base.minus(half)));
    }
}
