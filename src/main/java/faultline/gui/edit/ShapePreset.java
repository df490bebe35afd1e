package faultline.gui.edit;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/** The shapes of the palette, placed by a click in their default size or drawn from corner to corner. */
public enum ShapePreset {
    RECTANGLE(0.6, 0.4, false),
    /** A rectangle with equal sides. */
    SQUARE(0.4, 0.4, true),
    CIRCLE(0.4, 0.4, true),
    ELLIPSE(0.6, 0.4, false),
    /** A triangle on its base. */
    TRIANGLE(0.5, 0.45, false),
    /** A regular hexagon. */
    HEXAGON(0.5, 0.5, true),
    /** Two bars at a right angle. */
    ANGLE(0.6, 0.6, false);

    /** The minimum width and height of a drawn shape, metres. */
    private static final double MIN_SIZE = 0.02;
    /** The width of each bar of an angle, as a share of the size across the bar. */
    private static final double BAR_WIDTH = 0.4;

    /** The default width, metres. */
    private final double width;
    /** The default height, metres. */
    private final double height;

    private final boolean regular;

    ShapePreset(double width, double height, boolean regular) {
        this.width = width;
        this.height = height;
        this.regular = regular;
    }

    /** Returns the usual id of an obstacle of this shape, in the words of the menu. */
    public String id() {
        return this == ANGLE ? "l-shape" : name().toLowerCase(Locale.ROOT);
    }

    /** Returns an obstacle of the default size, given its id and its centre, metres. */
    public Obstacle createAt(String id, Vector2 middle) {
        return create(id, middle, width, height);
    }

    /**
     * Returns an obstacle in the rectangle between two points, metres, which is at least 2 cm wide and high. A regular
     * shape is in a square with the longer side, whose top and bottom a hexagon does not reach.
     */
    public Obstacle createBetween(String id, Vector2 from, Vector2 to) {
        double across = Math.max(MIN_SIZE, Math.abs(to.x() - from.x()));
        double up = Math.max(MIN_SIZE, Math.abs(to.y() - from.y()));
        double w = regular ? Math.max(across, up) : across;
        double h = regular ? Math.max(across, up) : up;
        Vector2 middle = new Vector2(
                from.x() + Math.copySign(w / 2, to.x() - from.x()), from.y() + Math.copySign(h / 2, to.y() - from.y()));
        return create(id, middle, w, h);
    }

    private Obstacle create(String id, Vector2 middle, double w, double h) {
        Vector2 place = Rounding.round(middle);
        return new Obstacle(id, shape(Rounding.round(w), Rounding.round(h)), new Pose(place.x(), place.y(), 0));
    }

    private ObstacleShape shape(double w, double h) {
        return switch (this) {
            case RECTANGLE, SQUARE -> new ObstacleShape.RectangleShape(w, h);
            case CIRCLE -> new ObstacleShape.CircleShape(w / 2);
            case ELLIPSE -> new ObstacleShape.EllipseShape(w / 2, h / 2);
            case TRIANGLE ->
                polygon(List.of(new Vector2(-w / 2, -h / 2), new Vector2(w / 2, -h / 2), new Vector2(0, h / 2)));
            case HEXAGON ->
                polygon(IntStream.range(0, 6)
                        .mapToObj(i -> Vector2.direction(i * Math.PI / 3).times(w / 2))
                        .toList());
            case ANGLE ->
                polygon(List.of(
                        new Vector2(-w / 2, -h / 2),
                        new Vector2(w / 2, -h / 2),
                        new Vector2(w / 2, (BAR_WIDTH - 0.5) * h),
                        new Vector2((BAR_WIDTH - 0.5) * w, (BAR_WIDTH - 0.5) * h),
                        new Vector2((BAR_WIDTH - 0.5) * w, h / 2),
                        new Vector2(-w / 2, h / 2)));
        };
    }

    private static ObstacleShape polygon(List<Vector2> points) {
        return new ObstacleShape.PolygonShape(Rounding.round(points));
    }
}
