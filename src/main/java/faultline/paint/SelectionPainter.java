package faultline.paint;

import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;
import faultline.geometry.Sector;
import faultline.geometry.Vec;
import faultline.robot.RobotSpec;
import faultline.world.Obstacle;
import java.awt.Color;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.Optional;

/**
 * Paints the selected obstacle's outline and the handle that turns it, and while a hand moves it, where it is wanted and by what
 * values.
 */
public final class SelectionPainter {

    /** The radius of the handle, pixels. */
    public static final double HANDLE_RADIUS = 6;

    private static final double SQUARE = 7;
    /** How far along a cone's edge its handle is. */
    private static final double EDGE_HANDLE = 0.75;
    private static final int BAND_ALPHA = 30;
    private static final double HANDLE_STALK = 24;
    private static final Stroke OUTLINE = Brush.solid(2);
    private static final Stroke KNOB = Brush.solid(1.4);
    private static final Stroke WANTED = Brush.dashed(1.6, 5, 4);
    private static final double VALUES_GAP = 26;
    private static final double VALUES_PADDING = 8;

    private SelectionPainter() {
    }

    /**
     * Where the handle that turns an obstacle is: above its middle while its heading is 0, and turning with it.
     *
     * @param camera from the world to the picture
     * @param obstacle the obstacle
     * @return pixels
     */
    public static Vec handle(Camera camera, Obstacle obstacle) {
        return stalk(camera, obstacle, HANDLE_STALK);
    }

    /**
     * Where the handle that turns several obstacles about their common middle is: above all of them.
     *
     * @param camera from the world to the picture
     * @param obstacles the obstacles, at least one
     * @return pixels
     */
    public static Vec handle(Camera camera, List<Obstacle> obstacles) {
        double top = obstacles.stream().mapToDouble(obstacle -> ObstacleOutlines.inWorld(obstacle).getBounds2D().getMaxY()).max().orElseThrow();
        Vec above = camera.toScreen(new Vec(ObstacleOutlines.middle(obstacles).x(), top));
        return new Vec(above.x(), above.y() - HANDLE_STALK);
    }

    private static Vec stalk(Camera camera, Obstacle obstacle, double beyond) {
        Rectangle2D bounds = ObstacleOutlines.local(obstacle.shape()).getBounds2D();
        double up = bounds.getHeight() / 2 * camera.scale() + beyond;
        Vec middle = camera.toScreen(ObstacleOutlines.middle(obstacle));
        Vec direction = Vec.direction(obstacle.pose().heading()).perpendicular();
        return new Vec(middle.x() + up * direction.x(), middle.y() - up * direction.y());
    }

    /**
     * Paints the outline of a selected obstacle.
     *
     * @param brush where to
     * @param obstacle the obstacle as it stands
     */
    public static void paintOutline(Brush brush, Obstacle obstacle) {
        brush.draw(outline(brush, obstacle), brush.palette().accent(), OUTLINE);
    }

    /**
     * Paints the handles of the only selected obstacle.
     *
     * @param brush where to
     * @param obstacle the obstacle as it stands
     * @param places of the handles that change its size, metres
     */
    public static void paintHandles(Brush brush, Obstacle obstacle, List<Vec> places) {
        paintHandle(brush, stalk(brush.camera(), obstacle, 0), handle(brush.camera(), obstacle));
        places.stream().map(brush.camera()::toScreen).forEach(place -> square(brush, place));
    }

    /**
     * Paints the handle of several selected obstacles.
     *
     * @param brush where to
     * @param obstacles the obstacles as they stand, at least one
     */
    public static void paintHandle(Brush brush, List<Obstacle> obstacles) {
        paintHandle(brush, brush.camera().toScreen(ObstacleOutlines.middle(obstacles)), handle(brush.camera(), obstacles));
    }

    private static void paintHandle(Brush brush, Vec foot, Vec handle) {
        brush.draw(new Line2D.Double(foot.x(), foot.y(), handle.x(), handle.y()), brush.palette().accent(), KNOB);
        knob(brush, new Ellipse2D.Double(handle.x() - HANDLE_RADIUS, handle.y() - HANDLE_RADIUS, 2 * HANDLE_RADIUS, 2 * HANDLE_RADIUS));
    }

    /** A square about a place of the picture. */
    private static void square(Brush brush, Vec place) {
        knob(brush, new Rectangle2D.Double(place.x() - SQUARE / 2, place.y() - SQUARE / 2, SQUARE, SQUARE));
    }

    private static void knob(Brush brush, Shape knob) {
        brush.fill(knob, brush.palette().canvas());
        brush.draw(knob, brush.palette().accent(), KNOB);
    }

    /**
     * Paints the outline of the selected sensor's cone, with handles on its rim and its edges.
     *
     * @param brush where to
     * @param sector the cone
     */
    public static void paintCone(Brush brush, Sector sector) {
        ScreenSector cone = ScreenSector.of(brush.camera(), sector);
        brush.draw(cone.outline(), brush.palette().accent(), OUTLINE);
        square(brush, cone.at(0.5, cone.radius()));
        square(brush, cone.at(0, cone.radius() * EDGE_HANDLE));
        square(brush, cone.at(1, cone.radius() * EDGE_HANDLE));
    }

    /**
     * Paints where a hand wants an obstacle, which the world need not have done yet.
     *
     * @param brush where to
     * @param there the obstacle as it is wanted
     * @param blocked whether it cannot be there
     */
    public static void paintWanted(Brush brush, Obstacle there, boolean blocked) {
        paintWanted(brush, outline(brush, there), blocked);
    }

    /**
     * Paints a frame about where a hand wants many obstacles, which the world need not have done yet.
     *
     * @param brush where to
     * @param there the obstacles as they are wanted, at least one
     * @param blocked whether one of them cannot be there
     */
    public static void paintWanted(Brush brush, List<Obstacle> there, boolean blocked) {
        paintWanted(brush, bounds(brush, there).orElseThrow(), blocked);
    }

    private static Optional<Rectangle2D> bounds(Brush brush, List<Obstacle> obstacles) {
        return obstacles.stream().map(obstacle -> outline(brush, obstacle).getBounds2D()).reduce(Rectangle2D::createUnion);
    }

    /**
     * Paints where a hand wants the robot.
     *
     * @param brush where to
     * @param robot the robot
     * @param pose its wanted pose
     * @param blocked whether it cannot be there
     */
    public static void paintRobot(Brush brush, RobotSpec robot, Pose pose, boolean blocked) {
        RobotPainter.paint(brush, robot, pose);
        Shape platform = new Rectangle2D.Double(-robot.length() / 2, -robot.width() / 2, robot.length(), robot.width());
        paintWanted(brush, brush.onScreen(platform, RigidMotion.to(pose)), blocked);
    }

    /** What cannot be is crossed out besides, because a colour alone says nothing to some. */
    private static void paintWanted(Brush brush, Shape outline, boolean blocked) {
        brush.draw(outline, blocked ? brush.palette().hit() : brush.palette().accent(), WANTED);
        if (blocked) {
            Rectangle2D box = outline.getBounds2D();
            brush.draw(new Line2D.Double(box.getMinX(), box.getMinY(), box.getMaxX(), box.getMaxY()), brush.palette().hit(), OUTLINE);
            brush.draw(new Line2D.Double(box.getMinX(), box.getMaxY(), box.getMaxX(), box.getMinY()), brush.palette().hit(), OUTLINE);
        }
    }

    /**
     * Paints points that are being drawn, joined by lines.
     *
     * @param brush where to
     * @param points metres, in the world, at least one; the last is under the mouse
     * @param closed whether the last is joined to the first
     */
    public static void paintSketch(Brush brush, List<Vec> points, boolean closed) {
        List<Vec> places = points.stream().map(brush.camera()::toScreen).toList();
        Path2D line = ObstacleOutlines.through(places);
        if (closed) {
            line.closePath();
        }
        brush.draw(line, brush.palette().accent(), WANTED);
        places.forEach(place -> square(brush, place));
    }

    /**
     * Paints a rubber band.
     *
     * @param brush where to
     * @param from where it began, pixels
     * @param to where it is, pixels
     */
    public static void paintBand(Brush brush, Vec from, Vec to) {
        Rectangle2D band = new Rectangle2D.Double();
        band.setFrameFromDiagonal(from.x(), from.y(), to.x(), to.y());
        brush.fill(band, Palette.translucent(brush.palette().accent(), BAND_ALPHA));
        brush.draw(band, brush.palette().accent(), KNOB);
    }

    /**
     * Paints what a hand is changing, in words: below the obstacles that it changes, or else beside the mouse.
     *
     * @param brush where to
     * @param values such as {@code x 1.20 m}
     * @param there the obstacles as they are wanted
     * @param mouse pixels
     */
    public static void paintValues(Brush brush, String values, List<Obstacle> there, Vec mouse) {
        paintPlate(brush, values, below(brush, there, mouse), brush.palette().accent());
    }

    /**
     * Paints why a hand cannot have what it wants, where {@link #paintValues} paints values.
     *
     * @param brush where to
     * @param reason one sentence
     * @param there the obstacles as they are wanted
     * @param mouse pixels
     */
    public static void paintRefusal(Brush brush, String reason, List<Obstacle> there, Vec mouse) {
        paintPlate(brush, reason, below(brush, there, mouse), brush.palette().hit());
    }

    private static Vec below(Brush brush, List<Obstacle> there, Vec mouse) {
        Rectangle2D bounds = bounds(brush, there).orElse(new Rectangle2D.Double(mouse.x(), mouse.y(), 0, 0));
        return new Vec(bounds.getCenterX(), bounds.getMaxY() + VALUES_GAP);
    }

    /** A plate about a place, moved into the picture where the place is not. */
    private static void paintPlate(Brush brush, String values, Vec place, Color edge) {
        Rectangle2D text = brush.measure(values);
        double halfWidth = text.getWidth() / 2 + VALUES_PADDING;
        double halfHeight = text.getHeight() / 2 + VALUES_PADDING / 2;
        double inX = within(place.x(), halfWidth, brush.camera().width() - halfWidth);
        double inY = within(place.y(), halfHeight, brush.camera().height() - halfHeight);
        Shape plate = new RoundRectangle2D.Double(inX - halfWidth, inY - halfHeight, 2 * halfWidth, 2 * halfHeight, 8, 8);
        brush.fill(plate, brush.palette().canvas());
        brush.draw(plate, edge, KNOB);
        brush.label(values, inX, inY, brush.palette().text());
    }

    private static double within(double value, double least, double most) {
        return Math.max(least, Math.min(most, value));
    }

    private static Shape outline(Brush brush, Obstacle obstacle) {
        return brush.onScreen(ObstacleOutlines.local(obstacle.shape()), RigidMotion.to(obstacle.pose()));
    }
}
