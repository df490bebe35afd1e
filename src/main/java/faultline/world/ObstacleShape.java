package faultline.world;

import faultline.geometry.EvenOddRule;
import faultline.geometry.Vector2;
import java.util.List;
import java.util.function.Function;

/**
 * The shape of an obstacle in its own frame. All shapes except the wall are solid. Code that depends on the kind of
 * shape gives {@link ShapeCases}, so that a new shape does not compile until it is handled everywhere.
 */
public sealed interface ObstacleShape {

    /**
     * {@return the result of the function for this kind of shape}
     *
     * @param <R> the type of the result
     * @param cases a function for each kind
     */
    <R> R match(ShapeCases<R> cases);

    /**
     * {@return whether a point of the obstacle's frame is inside; a point on the outline may give either result}
     *
     * @param local the point in the obstacle's frame, in metres
     */
    boolean contains(Vector2 local);

    /** {@return whether every surface is flat, so that it can be specular} */
    default boolean isFlat() {
        return true;
    }

    /** {@return the radius of the circle about the origin that encloses the shape, metres} */
    double boundingRadius();

    /**
     * A function for each kind of shape.
     *
     * @param <R> the type of the results
     * @param rectangle for a rectangle
     * @param circle for a circle
     * @param ellipse for an ellipse
     * @param polygon for a polygon
     * @param wall for a wall
     * @param plan for a floor plan
     */
    record ShapeCases<R>(
            Function<RectangleShape, R> rectangle,
            Function<CircleShape, R> circle,
            Function<EllipseShape, R> ellipse,
            Function<PolygonShape, R> polygon,
            Function<WallShape, R> wall,
            Function<PlanShape, R> plan) {}

    /**
     * A rectangle about the origin.
     *
     * @param width along x, metres, positive
     * @param height along y, metres, positive
     */
    record RectangleShape(double width, double height) implements ObstacleShape {
        /**
         * Creates a rectangle.
         *
         * @param width along x, metres, positive
         * @param height along y, metres, positive
         * @throws IllegalArgumentException if a side is not positive and finite
         */
        public RectangleShape {
            requirePositive("width", width);
            requirePositive("height", height);
        }

        @Override
        public <R> R match(ShapeCases<R> cases) {
            return cases.rectangle.apply(this);
        }

        @Override
        public boolean contains(Vector2 local) {
            return Math.abs(local.x()) <= width / 2 && Math.abs(local.y()) <= height / 2;
        }

        @Override
        public double boundingRadius() {
            return Math.sqrt(width * width + height * height) / 2;
        }

        /** {@return the corners, counter-clockwise from the first quadrant} */
        public List<Vector2> corners() {
            double x = width / 2;
            double y = height / 2;
            return List.of(new Vector2(x, y), new Vector2(-x, y), new Vector2(-x, -y), new Vector2(x, -y));
        }
    }

    /**
     * A circle about the origin.
     *
     * @param radius metres, positive
     */
    record CircleShape(double radius) implements ObstacleShape {
        /**
         * Creates a circle.
         *
         * @param radius metres, positive
         * @throws IllegalArgumentException if the radius is not positive and finite
         */
        public CircleShape {
            requirePositive("radius", radius);
        }

        @Override
        public <R> R match(ShapeCases<R> cases) {
            return cases.circle.apply(this);
        }

        @Override
        public boolean contains(Vector2 local) {
            return local.length() <= radius;
        }

        @Override
        public double boundingRadius() {
            return radius;
        }

        @Override
        public boolean isFlat() {
            return false;
        }
    }

    /**
     * An ellipse about the origin.
     *
     * @param rx half axis along x, metres, positive
     * @param ry half axis along y, metres, positive
     */
    record EllipseShape(double rx, double ry) implements ObstacleShape {
        /**
         * Creates an ellipse.
         *
         * @param rx half axis along x, metres, positive
         * @param ry half axis along y, metres, positive
         * @throws IllegalArgumentException if a half axis is not positive and finite
         */
        public EllipseShape {
            requirePositive("rx", rx);
            requirePositive("ry", ry);
        }

        @Override
        public <R> R match(ShapeCases<R> cases) {
            return cases.ellipse.apply(this);
        }

        @Override
        public boolean contains(Vector2 local) {
            return new Vector2(local.x() / rx, local.y() / ry).length() <= 1;
        }

        @Override
        public double boundingRadius() {
            return Math.max(rx, ry);
        }

        @Override
        public boolean isFlat() {
            return false;
        }
    }

    /**
     * A closed polygon, convex or not; a point is inside by the even-odd rule.
     *
     * @param points the points, at least three, in order; the last is connected to the first
     */
    record PolygonShape(List<Vector2> points) implements ObstacleShape {
        /**
         * Creates a polygon.
         *
         * @param points the points, at least three, in order; the last is connected to the first
         * @throws IllegalArgumentException if there are fewer than three points, or one is not finite
         */
        public PolygonShape {
            points = requirePoints("polygon", points, 3);
        }

        @Override
        public <R> R match(ShapeCases<R> cases) {
            return cases.polygon.apply(this);
        }

        @Override
        public boolean contains(Vector2 local) {
            return EvenOddRule.isInside(points, local);
        }

        @Override
        public double boundingRadius() {
            return maxLength(points);
        }
    }

    /**
     * An open polyline without thickness.
     *
     * @param points the points, at least two, in order
     */
    record WallShape(List<Vector2> points) implements ObstacleShape {
        /**
         * Creates a wall.
         *
         * @param points the points, at least two, in order
         * @throws IllegalArgumentException if there are fewer than two points, or one is not finite
         */
        public WallShape {
            points = requirePoints("wall", points, 2);
        }

        @Override
        public <R> R match(ShapeCases<R> cases) {
            return cases.wall.apply(this);
        }

        @Override
        public boolean contains(Vector2 local) {
            return false;
        }

        @Override
        public double boundingRadius() {
            return maxLength(points);
        }
    }

    /**
     * A floor plan: closed rings, such as the outlines of walls and of the rooms between them; a point is inside by the
     * even-odd rule over all rings.
     *
     * @param rings the rings, at least one; each has at least three points, in order, and its last point is connected
     *     to the first
     */
    record PlanShape(List<List<Vector2>> rings) implements ObstacleShape {
        /**
         * Creates a floor plan.
         *
         * @param rings the rings, at least one; each has at least three points, in order, and its last point is
         *     connected to the first
         * @throws IllegalArgumentException if there is no ring, a ring has fewer than three points, or a point is not
         *     finite
         */
        public PlanShape {
            rings = RingList.copyOf(rings);
        }

        /**
         * {@return the floor plan of points that are given by their coordinates, ring after ring}
         *
         * @param xs the x coordinates of all points, metres
         * @param ys the y coordinates of all points, metres
         * @param starts the index of the first point of each ring, and last the number of all points
         * @throws IllegalArgumentException if there is no ring, a ring has fewer than three points, a point is not
         *     finite, or the lengths of the arrays differ
         */
        public static PlanShape of(double[] xs, double[] ys, int[] starts) {
            return new PlanShape(RingList.of(xs, ys, starts));
        }

        /** {@return the number of points of all rings} */
        public int pointCount() {
            return points().sides();
        }

        @Override
        public <R> R match(ShapeCases<R> cases) {
            return cases.plan.apply(this);
        }

        @Override
        public boolean contains(Vector2 local) {
            return points().contains(local.x(), local.y());
        }

        @Override
        public double boundingRadius() {
            return points().maxLength();
        }

        /** Returns the rings with the coordinates of their points. */
        RingList points() {
            return (RingList) rings;
        }
    }

    private static double maxLength(List<Vector2> points) {
        double most = 0;
        for (int i = 0; i < points.size(); i++) {
            double square = points.get(i).dot(points.get(i));
            most = square > most ? square : most;
        }
        return Math.sqrt(most);
    }

    private static void requirePositive(String name, double value) {
        if (!(value > 0 && Double.isFinite(value))) {
            throw new IllegalArgumentException(name + " must be positive: " + value);
        }
    }

    private static List<Vector2> requirePoints(String name, List<Vector2> points, int min) {
        if (points.size() < min) {
            throw new IllegalArgumentException("a " + name + " needs at least " + min + " points: " + points.size());
        }
        for (int i = 0; i < points.size(); i++) {
            if (!points.get(i).isFinite()) {
                throw new IllegalArgumentException("the points of a " + name + " must be finite: " + points);
            }
        }
        return List.copyOf(points);
    }
}
