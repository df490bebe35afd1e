package faultline.paint;

import faultline.engine.Path;
import faultline.geometry.Vec;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;

/** Paints where the robot has been, or only a stretch of it, so that a picture of the path can grow instead of being made anew. */
public final class PathPainter {

    /** Points nearer to the last one than this are left out, pixels. */
    private static final double THINNING = 0.7;
    /** How far the line reaches beyond its middle, pixels. */
    private static final double BLEED = 2;
    /** Leaving a point out takes so many times less than drawing it. */
    private static final int CHEAPER = 8;
    /** A level line has a box that is not empty, pixels. */
    private static final double SLIGHT = 1e-3;

    private PathPainter() {
    }

    /**
     * Paints a path from a point on, as far as it is worth so many drawn points; points that are left out are worth less.
     *
     * @param brush where to
     * @param path the path
     * @param style how it is drawn
     * @param from the first point's index
     * @param most how many points may be drawn, about
     * @param clip what is to be painted, pixels; lines outside are left out
     * @return what was painted
     */
    public static Stretch paint(Brush brush, Path path, PathStyle style, int from, int most, Rectangle clip) {
        Line line = new Line(brush.camera(), path, from, clip);
        line.to(path.size(), most);
        brush.draw(line.drawn, style.colour(brush.palette()), style.stroke());
        return new Stretch(line.next, (double) line.cost / CHEAPER);
    }

    /**
     * A stretch of a path that was painted.
     *
     * @param end the index after its last point
     * @param cost how many points it was worth
     */
    public record Stretch(int end, double cost) {
    }

    /** Paints a stretch of a path from a point to its end, and on to where the robot is now. */
    static void paintTail(Brush brush, Path path, int from, Vec robot) {
        Line line = new Line(brush.camera(), path, from, brush.camera().bounds());
        line.to(path.size(), Integer.MAX_VALUE);
        Vec end = brush.camera().toScreen(robot);
        line.join(end.x(), end.y());
        brush.draw(line.drawn, PathStyle.RUN.colour(brush.palette()), PathStyle.RUN.stroke());
    }

    /** A line through some of the points of a path. */
    private static final class Line {

        private final Path2D drawn = new Path2D.Double();
        private final AffineTransform toScreen;
        private final Path path;
        private final Rectangle2D clip;
        private final Rectangle2D clipInWorld;
        private final double[] point = new double[2];
        private double lastX;
        private double lastY;
        private boolean down;
        private int next;
        private long cost;

        Line(Camera camera, Path path, int from, Rectangle clip) {
            this.toScreen = camera.transform();
            this.path = path;
            this.clip = grown(clip);
            this.clipInWorld = inWorld(camera, this.clip);
            read(from);
            last();
            next = from + 1;
        }

        private static Rectangle2D grown(Rectangle clip) {
            return new Rectangle2D.Double(clip.x - BLEED, clip.y - BLEED, clip.width + 2 * BLEED, clip.height + 2 * BLEED);
        }

        private static Rectangle2D inWorld(Camera camera, Rectangle2D box) {
            Vec lower = camera.toWorld(new Vec(box.getMinX(), box.getMaxY()));
            return new Rectangle2D.Double(lower.x(), lower.y(), box.getWidth() / camera.scale(), box.getHeight() / camera.scale());
        }

        void to(int end, int most) {
            long enough = (long) most * CHEAPER;
            while (next < end && cost < enough) {
                int outside = path.outside(next, clipInWorld);
                read(next);
                next += Math.max(1, outside);
                cost++;
                if (outside > 0 || next == end || cost >= enough || isFarEnough()) {
                    draw();
                }
                if (outside > 0) {
                    lift();
                }
            }
        }

        /** Goes on from the last point that was passed, without drawing. */
        private void lift() {
            read(next - 1);
            last();
            down = false;
        }

        private void read(int index) {
            point[0] = path.x(index);
            point[1] = path.y(index);
            toScreen.transform(point, 0, point, 0, 1);
        }

        private void last() {
            lastX = point[0];
            lastY = point[1];
        }

        private boolean isFarEnough() {
            double dx = point[0] - lastX;
            double dy = point[1] - lastY;
            return dx * dx + dy * dy >= THINNING * THINNING;
        }

        private void draw() {
            boolean visible = clip.intersects(Math.min(lastX, point[0]), Math.min(lastY, point[1]),
                    Math.abs(point[0] - lastX) + SLIGHT, Math.abs(point[1] - lastY) + SLIGHT);
            if (visible) {
                join(point[0], point[1]);
            }
            down = visible;
            last();
        }

        void join(double x, double y) {
            if (!down) {
                drawn.moveTo(lastX, lastY);
            }
            drawn.lineTo(x, y);
            cost += CHEAPER;
        }
    }
}
