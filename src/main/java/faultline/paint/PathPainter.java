package faultline.paint;

import faultline.engine.Path;
import faultline.geometry.Vec;
import java.awt.Stroke;
import java.awt.geom.Path2D;

/** Paints where the robot has been, or only a stretch of it, so that a picture of the path can grow instead of being made anew. */
public final class PathPainter {

    private static final Stroke STROKE = Brush.solid(2);
    /** Points nearer to the last one than this are left out, pixels. */
    private static final double THINNING = 0.7;

    private PathPainter() {
    }

    /**
     * Paints a stretch of a path.
     *
     * @param brush where to
     * @param path the path
     * @param from the first point's index
     * @param to the index after the last point
     */
    public static void paint(Brush brush, Path path, int from, int to) {
        if (from < to) {
            brush.draw(stretch(brush.camera(), path, from, to), brush.palette().path(), STROKE);
        }
    }

    /** Paints a stretch of a path from a point to its end, and on to where the robot is now. */
    static void paintTail(Brush brush, Path path, int from, Vec robot) {
        Path2D line = stretch(brush.camera(), path, from, path.size());
        Vec end = brush.camera().toScreen(robot);
        line.lineTo(end.x(), end.y());
        brush.draw(line, brush.palette().path(), STROKE);
    }

    private static Path2D stretch(Camera camera, Path path, int from, int to) {
        Path2D line = new Path2D.Double();
        Vec last = point(camera, path, from);
        line.moveTo(last.x(), last.y());
        for (int i = from + 1; i < to; i++) {
            Vec next = point(camera, path, i);
            if (i == to - 1 || next.distanceTo(last) >= THINNING) {
                line.lineTo(next.x(), next.y());
                last = next;
            }
        }
        return line;
    }

    private static Vec point(Camera camera, Path path, int index) {
        return camera.toScreen(new Vec(path.x(index), path.y(index)));
    }
}
