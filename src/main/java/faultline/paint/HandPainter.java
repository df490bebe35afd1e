package faultline.paint;

import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;
import faultline.geometry.Vec;
import faultline.robot.RobotSpec;
import faultline.world.Obstacle;
import java.awt.Color;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.Optional;

/** Paints what a hand is about: where it wants things, by what values, what it draws, and why it cannot have what it wants. */
public final class HandPainter {

    private static final int BAND_ALPHA = 30;
    private static final Stroke EDGE = Brush.solid(1.4);
    private static final Stroke CROSS = Brush.solid(2);
    private static final Stroke WANTED = Brush.dashed(1.6, 5, 4);
    private static final double VALUES_GAP = 26;
    private static final double VALUES_PADDING = 8;

    private HandPainter() {
    }

    /**
     * Paints where a hand wants an obstacle, which the world need not have done yet.
     *
     * @param brush where to
     * @param there the obstacle as it is wanted
     * @param blocked whether it cannot be there
     */
    public static void paintWanted(Brush brush, Obstacle there, boolean blocked) {
        paintWanted(brush, SelectionPainter.outline(brush, there), blocked);
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
        return obstacles.stream().map(obstacle -> SelectionPainter.outline(brush, obstacle).getBounds2D()).reduce(Rectangle2D::createUnion);
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
            brush.draw(new Line2D.Double(box.getMinX(), box.getMinY(), box.getMaxX(), box.getMaxY()), brush.palette().hit(), CROSS);
            brush.draw(new Line2D.Double(box.getMinX(), box.getMaxY(), box.getMaxX(), box.getMinY()), brush.palette().hit(), CROSS);
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
        places.forEach(place -> SelectionPainter.square(brush, place));
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
        brush.draw(band, brush.palette().accent(), EDGE);
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
        brush.draw(plate, edge, EDGE);
        brush.label(values, inX, inY, brush.palette().text());
    }

    private static double within(double value, double least, double most) {
        return Math.max(least, Math.min(most, value));
    }
}
