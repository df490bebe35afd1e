package faultline.paint.scene;

import faultline.engine.RobotPath;
import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;

/**
 * Paints where the robot has been, or only a stretch of it, so that a picture of the path can grow instead of being
 * made anew.
 */
public final class PathPainter {

    /** Points nearer to the last one than this are left out, pixels. */
    private static final double THINNING = 0.7;
    /** How far the line reaches beyond its middle, pixels. */
    private static final double LINE_MARGIN = 2;
    /** Leaving a point out takes so many times less than drawing it. */
    private static final int DRAW_COST = 8;
    /** A level line has a box that is not empty, pixels. */
    private static final double MIN_EXTENT = 1e-3;

    private PathPainter() {}

    /**
     * Paints a path from a point on, as far as it is worth so many drawn points; points that are left out are worth
     * less.
     *
     * @param brush where to
     * @param path the path
     * @param style how it is drawn
     * @param from the first point's index
     * @param most how many points may be drawn, about
     * @param clip what is to be painted, pixels; lines outside are left out
     * @return what was painted
     */
    public static PaintedSection paint(
            DrawContext brush, RobotPath path, PathStyle style, int from, int most, Rectangle clip) {
        PolylineBuilder line = new PolylineBuilder(brush.camera(), path, from, clip);
        line.appendUpTo(path.size(), most);
        brush.draw(line.drawn, style.colour(brush.palette()), style.stroke());
        return new PaintedSection(line.next, (double) line.cost / DRAW_COST);
    }

    /**
     * A stretch of a path that was painted.
     *
     * @param endIndex the index after its last point
     * @param cost how many points it was worth
     */
    public record PaintedSection(int endIndex, double cost) {}

    /** Paints a stretch of a path from a point to its end, and on to where the robot is now. */
    static void paintTail(DrawContext brush, RobotPath path, int from, Vector2 robot) {
        PolylineBuilder line =
                new PolylineBuilder(brush.camera(), path, from, brush.camera().bounds());
        line.appendUpTo(path.size(), Integer.MAX_VALUE);
        Vector2 end = brush.camera().toScreen(robot);
        line.lineTo(end.x(), end.y());
        brush.draw(line.drawn, PathStyle.RUN.colour(brush.palette()), PathStyle.RUN.stroke());
    }

    /** A line through some of the points of a path. */
    private static final class PolylineBuilder {

        private final Path2D drawn = new Path2D.Double();
        private final AffineTransform toScreen;
        private final RobotPath path;
        private final Rectangle2D clip;
        private final Rectangle2D clipInWorld;
        private final double[] point = new double[2];
        private double lastX;
        private double lastY;
        private boolean penDown;
        private int next;
        private long cost;

        PolylineBuilder(Camera camera, RobotPath path, int from, Rectangle clip) {
            this.toScreen = camera.transform();
            this.path = path;
            this.clip = expanded(clip);
            this.clipInWorld = toWorld(camera, this.clip);
            loadPoint(from);
            markLast();
            next = from + 1;
        }

        private static Rectangle2D expanded(Rectangle clip) {
            return new Rectangle2D.Double(
                    clip.x - LINE_MARGIN,
                    clip.y - LINE_MARGIN,
                    clip.width + 2 * LINE_MARGIN,
                    clip.height + 2 * LINE_MARGIN);
        }

        private static Rectangle2D toWorld(Camera camera, Rectangle2D box) {
            Vector2 lower = camera.toWorld(new Vector2(box.getMinX(), box.getMaxY()));
            return new Rectangle2D.Double(
                    lower.x(), lower.y(), box.getWidth() / camera.scale(), box.getHeight() / camera.scale());
        }

        void appendUpTo(int end, int most) {
            long enough = (long) most * DRAW_COST;
            while (next < end && cost < enough) {
                int outside = path.skippablePoints(next, clipInWorld);
                loadPoint(next);
                next += Math.max(1, outside);
                cost++;
                if (outside > 0 || next == end || cost >= enough || isFarEnough()) {
                    draw();
                }
                if (outside > 0) {
                    liftPen();
                }
            }
        }

        /** Goes on from the last point that was passed, without drawing. */
        private void liftPen() {
            loadPoint(next - 1);
            markLast();
            penDown = false;
        }

        private void loadPoint(int index) {
            point[0] = path.x(index);
            point[1] = path.y(index);
            toScreen.transform(point, 0, point, 0, 1);
        }

        private void markLast() {
            lastX = point[0];
            lastY = point[1];
        }

        private boolean isFarEnough() {
            double dx = point[0] - lastX;
            double dy = point[1] - lastY;
            return dx * dx + dy * dy >= THINNING * THINNING;
        }

        private void draw() {
            boolean visible = clip.intersects(
                    Math.min(lastX, point[0]),
                    Math.min(lastY, point[1]),
                    Math.abs(point[0] - lastX) + MIN_EXTENT,
                    Math.abs(point[1] - lastY) + MIN_EXTENT);
            if (visible) {
                lineTo(point[0], point[1]);
            }
            penDown = visible;
            markLast();
        }

        void lineTo(double x, double y) {
            if (!penDown) {
                drawn.moveTo(lastX, lastY);
            }
            drawn.lineTo(x, y);
            cost += DRAW_COST;
        }
    }
}
