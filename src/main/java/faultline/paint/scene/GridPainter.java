package faultline.paint.scene;

import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import java.awt.Color;
import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;

/** Paints a grid whose steps are round and adapt to the zoom. */
final class GridPainter {

    /** Major lines are at least this far apart, pixels. */
    private static final double MIN_MAJOR_SPACING = 80;

    private GridPainter() {}

    static void paint(DrawContext brush) {
        double major = NiceSteps.atLeast(MIN_MAJOR_SPACING / brush.camera().scale());
        paintLines(brush, major / NiceSteps.subdivisions(major), brush.palette().grid());
        paintLines(brush, major, brush.palette().gridMajor());
    }

    private static void paintLines(DrawContext brush, double step, Color colour) {
        Camera camera = brush.camera();
        Rectangle2D visible = camera.visibleArea();
        for (double i = Math.ceil(visible.getMinX() / step); i * step <= visible.getMaxX(); i++) {
            int x = toPixel(camera.width() / 2.0 + camera.scale() * (i * step - camera.x()));
            brush.fill(new Rectangle(x, 0, 1, camera.height()), colour);
        }
        for (double i = Math.ceil(visible.getMinY() / step); i * step <= visible.getMaxY(); i++) {
            int y = toPixel(camera.height() / 2.0 - camera.scale() * (i * step - camera.y()));
            brush.fill(new Rectangle(0, y, camera.width(), 1), colour);
        }
    }

    /** The pixel that a coordinate falls into: a thin line that fills it is sharp, and not two pale ones. */
    private static int toPixel(double coordinate) {
        return (int) Math.floor(coordinate);
    }
}
