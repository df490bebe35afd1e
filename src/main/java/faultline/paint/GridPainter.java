package faultline.paint;

import java.awt.Color;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;

/** Paints a grid whose steps are round and adapt to the zoom. */
final class GridPainter {

    /** Major lines are at least this far apart, pixels. */
    private static final double LEAST_MAJOR = 80;

    private GridPainter() {
    }

    static void paint(Brush brush) {
        double major = RoundSteps.atLeast(LEAST_MAJOR / brush.camera().scale());
        lines(brush, major / RoundSteps.parts(major), brush.palette().grid());
        lines(brush, major, brush.palette().gridMajor());
    }

    private static void lines(Brush brush, double step, Color colour) {
        Camera camera = brush.camera();
        Rectangle2D visible = camera.visible();
        for (double i = Math.ceil(visible.getMinX() / step); i * step <= visible.getMaxX(); i++) {
            double x = sharp(camera.width() / 2.0 + camera.scale() * (i * step - camera.x()));
            brush.draw(new Line2D.Double(x, 0, x, camera.height()), colour, Brush.solid(1));
        }
        for (double i = Math.ceil(visible.getMinY() / step); i * step <= visible.getMaxY(); i++) {
            double y = sharp(camera.height() / 2.0 - camera.scale() * (i * step - camera.y()));
            brush.draw(new Line2D.Double(0, y, camera.width(), y), colour, Brush.solid(1));
        }
    }

    /** The middle of the pixel that a coordinate falls into: a thin line there is one pixel wide and not two pale ones. */
    private static double sharp(double coordinate) {
        return Math.floor(coordinate) + 0.5;
    }
}
