package faultline.paint;

import java.awt.Color;
import java.awt.Rectangle;
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
            int x = pixel(camera.width() / 2.0 + camera.scale() * (i * step - camera.x()));
            brush.fill(new Rectangle(x, 0, 1, camera.height()), colour);
        }
        for (double i = Math.ceil(visible.getMinY() / step); i * step <= visible.getMaxY(); i++) {
            int y = pixel(camera.height() / 2.0 - camera.scale() * (i * step - camera.y()));
            brush.fill(new Rectangle(0, y, camera.width(), 1), colour);
        }
    }

    /** The pixel that a coordinate falls into: a thin line that fills it is sharp, and not two pale ones. */
    private static int pixel(double coordinate) {
        return (int) Math.floor(coordinate);
    }
}
