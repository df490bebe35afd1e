package faultline.gui.edit;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.List;
import java.util.stream.IntStream;

/** The shapes of the palette: placed by a click in their usual size, or drawn from corner to corner. */
public enum ReadyShape {
    /** A rectangle. */
    RECTANGLE(0.6, 0.4, false),
    /** A rectangle with equal sides. */
    SQUARE(0.4, 0.4, true),
    /** A circle. */
    CIRCLE(0.4, 0.4, true),
    /** An ellipse. */
    ELLIPSE(0.6, 0.4, false),
    /** A triangle on its base. */
    TRIANGLE(0.5, 0.45, false),
    /** A regular hexagon. */
    HEXAGON(0.5, 0.5, true),
    /** Two bars at a right angle. */
    ANGLE(0.6, 0.6, false);

    private static final double LEAST = 0.02;
    private static final double BAR = 0.4;

    private final double width;
    private final double height;
    private final boolean regular;

    ReadyShape(double width, double height, boolean regular) {
        this.width = width;
        this.height = height;
        this.regular = regular;
    }

    /**
     * An obstacle of the usual size.
     *
     * @param id its id
     * @param middle where, metres
     * @return the obstacle
     */
    public Obstacle at(String id, Vec middle) {
        return placed(id, middle, width, height);
    }

    /**
     * An obstacle from one corner of its bounds to the opposite one; one of a regular shape takes the longer side for both.
     *
     * @param id its id
     * @param from a corner, metres
     * @param to the opposite corner, metres
     * @return the obstacle, two centimetres wide and high at least
     */
    public Obstacle between(String id, Vec from, Vec to) {
        double across = Math.max(LEAST, Math.abs(to.x() - from.x()));
        double up = Math.max(LEAST, Math.abs(to.y() - from.y()));
        double w = regular ? Math.max(across, up) : across;
        double h = regular ? Math.max(across, up) : up;
        Vec middle = new Vec(from.x() + Math.copySign(w / 2, to.x() - from.x()), from.y() + Math.copySign(h / 2, to.y() - from.y()));
        return placed(id, middle, w, h);
    }

    private Obstacle placed(String id, Vec middle, double w, double h) {
        Vec place = Metres.round(middle);
        return new Obstacle(id, shape(Metres.round(w), Metres.round(h)), new Pose(place.x(), place.y(), 0));
    }

    private ObstacleShape shape(double w, double h) {
        return switch (this) {
            case RECTANGLE, SQUARE -> new ObstacleShape.Rectangle(w, h);
            case CIRCLE -> new ObstacleShape.Circle(w / 2);
            case ELLIPSE -> new ObstacleShape.Ellipse(w / 2, h / 2);
            case TRIANGLE -> polygon(List.of(new Vec(-w / 2, -h / 2), new Vec(w / 2, -h / 2), new Vec(0, h / 2)));
            case HEXAGON -> polygon(IntStream.range(0, 6).mapToObj(i -> Vec.direction(i * Math.PI / 3).times(w / 2)).toList());
            case ANGLE -> polygon(List.of(new Vec(-w / 2, -h / 2), new Vec(w / 2, -h / 2), new Vec(w / 2, (BAR - 0.5) * h),
                    new Vec((BAR - 0.5) * w, (BAR - 0.5) * h), new Vec((BAR - 0.5) * w, h / 2), new Vec(-w / 2, h / 2)));
        };
    }

    private static ObstacleShape polygon(List<Vec> points) {
        return new ObstacleShape.Polygon(Metres.round(points));
    }
}
