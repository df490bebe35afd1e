package faultline.paint;

import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;
import faultline.geometry.Vec;
import faultline.world.Obstacle;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;

/**
 * Paints the selected obstacle's outline and the handle that turns it, and while a hand moves it, where it is wanted and by what
 * values.
 */
public final class SelectionPainter {

    /** The radius of the handle, pixels. */
    public static final double HANDLE_RADIUS = 6;

    private static final double HANDLE_STALK = 24;
    private static final Stroke OUTLINE = Brush.solid(2);
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

    private static Vec stalk(Camera camera, Obstacle obstacle, double beyond) {
        Rectangle2D bounds = ObstacleOutlines.local(obstacle.shape()).getBounds2D();
        double up = bounds.getHeight() / 2 * camera.scale() + beyond;
        Vec middle = camera.toScreen(ObstacleOutlines.middle(obstacle));
        Vec direction = Vec.direction(obstacle.pose().heading()).perpendicular();
        return new Vec(middle.x() + up * direction.x(), middle.y() - up * direction.y());
    }

    /**
     * Paints the outline and the handle of the selected obstacle.
     *
     * @param brush where to
     * @param obstacle the obstacle as it stands
     */
    public static void paint(Brush brush, Obstacle obstacle) {
        brush.draw(outline(brush, obstacle), brush.palette().accent(), OUTLINE);
        Vec foot = stalk(brush.camera(), obstacle, 0);
        Vec handle = handle(brush.camera(), obstacle);
        brush.draw(new Line2D.Double(foot.x(), foot.y(), handle.x(), handle.y()), brush.palette().accent(), Brush.solid(1.4));
        Shape knob = new Ellipse2D.Double(handle.x() - HANDLE_RADIUS, handle.y() - HANDLE_RADIUS, 2 * HANDLE_RADIUS, 2 * HANDLE_RADIUS);
        brush.fill(knob, brush.palette().canvas());
        brush.draw(knob, brush.palette().accent(), OUTLINE);
    }

    /**
     * Paints where a hand wants an obstacle, which the world need not have done yet.
     *
     * @param brush where to
     * @param obstacle the obstacle
     * @param wanted its wanted pose
     * @param values what the hand is changing, such as {@code x 1.20 m}
     */
    public static void paintWanted(Brush brush, Obstacle obstacle, Pose wanted, String values) {
        Obstacle there = obstacle.at(wanted);
        brush.draw(outline(brush, there), brush.palette().accent(), WANTED);
        Rectangle2D bounds = outline(brush, there).getBounds2D();
        paintValues(brush, values, bounds.getCenterX(), bounds.getMaxY() + VALUES_GAP);
    }

    /** A plate about a place, moved into the picture where the place is not. */
    private static void paintValues(Brush brush, String values, double x, double y) {
        Rectangle2D text = brush.measure(values);
        double halfWidth = text.getWidth() / 2 + VALUES_PADDING;
        double halfHeight = text.getHeight() / 2 + VALUES_PADDING / 2;
        double inX = within(x, halfWidth, brush.camera().width() - halfWidth);
        double inY = within(y, halfHeight, brush.camera().height() - halfHeight);
        Shape plate = new RoundRectangle2D.Double(inX - halfWidth, inY - halfHeight, 2 * halfWidth, 2 * halfHeight, 8, 8);
        brush.fill(plate, brush.palette().canvas());
        brush.draw(plate, brush.palette().accent(), Brush.solid(1.4));
        brush.label(values, inX, inY, brush.palette().text());
    }

    private static double within(double value, double least, double most) {
        return Math.max(least, Math.min(most, value));
    }

    private static Shape outline(Brush brush, Obstacle obstacle) {
        return brush.onScreen(ObstacleOutlines.local(obstacle.shape()), RigidMotion.to(obstacle.pose()));
    }
}
