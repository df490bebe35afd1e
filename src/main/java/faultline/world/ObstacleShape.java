package faultline.world;

import faultline.geometry.Vector2;
import java.util.List;

/**
 * The shape of an obstacle in its own frame, before its pose is applied. All but the wall are solid: their inside
 * belongs to them.
 */
public sealed interface ObstacleShape {

    /**
     * A rectangle about the origin.
     *
     * @param width along x, metres, positive
     * @param height along y, metres, positive
     */
    record Rectangle(double width, double height) implements ObstacleShape {
        public Rectangle {
            requirePositive("width", width);
            requirePositive("height", height);
        }
    }

    /**
     * A circle about the origin.
     *
     * @param radius metres, positive
     */
    record Circle(double radius) implements ObstacleShape {
        public Circle {
            requirePositive("radius", radius);
        }
    }

    /**
     * An ellipse about the origin.
     *
     * @param rx half axis along x, metres, positive
     * @param ry half axis along y, metres, positive
     */
    record Ellipse(double rx, double ry) implements ObstacleShape {
        public Ellipse {
            requirePositive("rx", rx);
            requirePositive("ry", ry);
        }
    }

    /**
     * A closed polygon, convex or not; a point is inside by the even-odd rule.
     *
     * @param points at least three, in order; the last is joined to the first
     */
    record Polygon(List<Vector2> points) implements ObstacleShape {
        public Polygon {
            points = requirePoints("polygon", points, 3);
        }
    }

    /**
     * An open polyline without thickness.
     *
     * @param points at least two, in order
     */
    record Wall(List<Vector2> points) implements ObstacleShape {
        public Wall {
            points = requirePoints("wall", points, 2);
        }
    }

    private static void requirePositive(String name, double value) {
        if (!(value > 0 && Double.isFinite(value))) {
            throw new IllegalArgumentException(name + " must be positive: " + value);
        }
    }

    private static List<Vector2> requirePoints(String name, List<Vector2> points, int least) {
        if (points.size() < least) {
            throw new IllegalArgumentException("a " + name + " needs at least " + least + " points: " + points.size());
        }
        if (!points.stream().allMatch(Vector2::isFinite)) {
            throw new IllegalArgumentException("the points of a " + name + " must be finite: " + points);
        }
        return List.copyOf(points);
    }
}
