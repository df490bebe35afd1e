package faultline.paint.scene;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.robot.RobotSpec;
import java.awt.geom.Rectangle2D;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/**
 * Keeps a box in a corner of a picture, out of the robot's way. The box stays in its corner until something comes to
 * lie below it, and then moves to the corner that is farthest from that.
 */
public final class CornerChoice {

    /** The distance ahead of the robot that is kept free, metres. */
    private static final double AHEAD = 0.6;
    /** The distance from the corners of the platform to the edge of what is kept free, pixels. */
    private static final double REACH = 24;

    private final List<Corner> preferred;
    private Corner corner;

    /** A corner of a picture. */
    public enum Corner {
        UPPER_LEFT(0, 0),
        UPPER_RIGHT(1, 0),
        LOWER_LEFT(0, 1),
        LOWER_RIGHT(1, 1);

        private final int right;
        private final int down;

        Corner(int right, int down) {
            this.right = right;
            this.down = down;
        }

        /** Returns a box of the size of another one, in this corner of an area. */
        private Rectangle2D place(Rectangle2D area, Rectangle2D box) {
            return new Rectangle2D.Double(
                    area.getX() + right * Math.max(0, area.getWidth() - box.getWidth()),
                    area.getY() + down * Math.max(0, area.getHeight() - box.getHeight()),
                    box.getWidth(),
                    box.getHeight());
        }
    }

    /** Creates a choice of some corners, the preferred one first. */
    public CornerChoice(Corner... corners) {
        preferred = List.of(corners);
        corner = preferred.get(0);
    }

    /**
     * Returns the place of a box, of which only the size is used, in a corner of an area. The avoided areas should stay
     * visible. All are in pixels.
     */
    public Rectangle2D place(Rectangle2D area, Rectangle2D box, List<Rectangle2D> avoided) {
        return place(area, box, avoided, List.of());
    }

    /** Returns a place as above that also leaves other areas visible if a corner is free of all of them. */
    Rectangle2D place(Rectangle2D area, Rectangle2D box, List<Rectangle2D> avoided, List<Rectangle2D> others) {
        List<Rectangle2D> all = Stream.of(avoided, others).flatMap(List::stream).toList();
        boolean anyFree = preferred.stream().anyMatch(other -> overlap(other, area, box, all) == 0);
        moveIfTaken(area, box, anyFree ? all : avoided);
        return corner.place(area, box);
    }

    private void moveIfTaken(Rectangle2D area, Rectangle2D box, List<Rectangle2D> avoided) {
        if (overlap(corner, area, box, avoided) > 0) {
            corner = preferred.stream()
                    .min(Comparator.<Corner>comparingDouble(other -> overlap(other, area, box, avoided))
                            .thenComparingDouble(other -> -distance(other.place(area, box), avoided)))
                    .orElseThrow();
        }
    }

    /** Returns the area that a box in a corner would hide, square pixels. */
    private static double overlap(Corner corner, Rectangle2D area, Rectangle2D box, List<Rectangle2D> avoided) {
        Rectangle2D placed = corner.place(area, box);
        return avoided.stream()
                .filter(placed::intersects)
                .map(placed::createIntersection)
                .mapToDouble(hidden -> hidden.getWidth() * hidden.getHeight())
                .sum();
    }

    /** Returns the distance of the centre of a box from the nearest other one. */
    private static double distance(Rectangle2D placed, List<Rectangle2D> avoided) {
        return avoided.stream()
                .mapToDouble(other ->
                        Math.hypot(other.getCenterX() - placed.getCenterX(), other.getCenterY() - placed.getCenterY()))
                .min()
                .orElse(0);
    }

    /** Returns what a robot and its way ahead take of a picture, pixels. */
    public static Rectangle2D robotArea(Camera camera, RobotSpec robot, Pose pose) {
        double radius = camera.scale() * Math.hypot(robot.length(), robot.width()) / 2 + REACH;
        Vector2 middle = camera.toScreen(pose.position());
        Vector2 ahead = camera.toScreen(pose.toParent(new Vector2(AHEAD, 0)));
        Rectangle2D area = new Rectangle2D.Double();
        area.setFrameFromDiagonal(middle.x(), middle.y(), ahead.x(), ahead.y());
        return new Rectangle2D.Double(
                area.getX() - radius,
                area.getY() - radius,
                area.getWidth() + 2 * radius,
                area.getHeight() + 2 * radius);
    }
}
