package faultline.paint.scene;

import faultline.engine.RobotPath;
import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import java.awt.Color;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.IntFunction;

/** Paints the path of the robot, or a section of it, so that a cached picture of the path can grow. */
public final class PathPainter {

    /** Points nearer than this to the last one are omitted, pixels. */
    private static final double THINNING = 0.7;
    /** The reach of the line beyond its middle, pixels. */
    private static final double LINE_MARGIN = 2;
    /** The cost of drawing a point relative to that of leaving it out. */
    private static final int DRAW_COST = 8;
    /** A horizontal line needs a bounding box that is not empty, pixels. */
    private static final double MIN_EXTENT = 1e-3;

    private PathPainter() {}

    /**
     * Paints a section of a path from a point on, until about {@code most} points are drawn; points that are omitted
     * cost less. Lines outside the clip, pixels, are omitted.
     */
    public static PaintedSection paint(
            DrawContext context, RobotPath path, PathStyle style, int from, int most, Rectangle clip) {
        PolylineBuilder line = new PolylineBuilder(context, path, style, from, clip);
        line.appendUpTo(path.size(), most);
        line.draw(context, style);
        return new PaintedSection(line.next, (double) line.cost / DRAW_COST);
    }

    /** A painted section of a path: the index after its last point, and the number of drawn points that it cost. */
    public record PaintedSection(int endIndex, double cost) {}

    /** Paints the rest of a path from a point, and on to the robot's current position. */
    static void paintTail(DrawContext context, RobotPath path, PathStyle style, int from, Vector2 robot) {
        PolylineBuilder line =
                new PolylineBuilder(context, path, style, from, context.camera().bounds());
        line.appendUpTo(path.size(), Integer.MAX_VALUE);
        Vector2 end = context.camera().toScreen(robot);
        line.lineTo(end.x(), end.y());
        line.draw(context, style);
    }

    /** Builds a line through some of the points of a path. */
    private static final class PolylineBuilder {

        /** The lines of each colour. */
        private final Map<Color, Path2D> lines = new LinkedHashMap<>();

        private final IntFunction<Color> colours;
        private final AffineTransform toScreen;
        private final RobotPath path;
        private final Rectangle2D clip;
        private final Rectangle2D clipInWorld;
        private final double[] point = new double[2];
        private double lastX;
        private double lastY;
        private boolean penDown;
        private Color colour;
        private int next;
        private long cost;

        PolylineBuilder(DrawContext context, RobotPath path, PathStyle style, int from, Rectangle clip) {
            Camera camera = context.camera();
            this.colours = tag -> style.colour(context.palette(), tag);
            this.colour = colours.apply(path.tag(from));
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
                changeColour(colours.apply(path.tag(next)));
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

        /** Draws up to the last point before a line of another colour begins there. */
        private void changeColour(Color newColour) {
            if (!newColour.equals(colour)) {
                loadPoint(next - 1);
                draw();
                penDown = false;
                colour = newColour;
            }
        }

        void draw(DrawContext context, PathStyle style) {
            lines.forEach((lineColour, line) -> context.draw(line, lineColour, style.stroke()));
        }

        /** Continues from the last point without drawing. */
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
            Path2D line = lines.computeIfAbsent(colour, unused -> new Path2D.Double());
            if (!penDown) {
                line.moveTo(lastX, lastY);
            }
            line.lineTo(x, y);
            cost += DRAW_COST;
        }
    }
}
