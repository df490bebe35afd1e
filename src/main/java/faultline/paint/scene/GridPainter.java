package faultline.paint.scene;

import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.NiceSteps;
import java.awt.Color;
import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;

/** Paints a grid with nice steps that depend on the zoom. */
final class GridPainter {

    /** The minimum distance between major lines, pixels. */
    private static final double MIN_MAJOR_SPACING = 80;

    private GridPainter() {}

    static void paint(DrawContext context) {
        double major = NiceSteps.atLeast(MIN_MAJOR_SPACING / context.camera().scale());
        paintLines(
                context,
                major / NiceSteps.subdivisions(major),
                context.palette().grid());
        paintLines(context, major, context.palette().gridMajor());
    }

    private static void paintLines(DrawContext context, double step, Color colour) {
        Camera camera = context.camera();
        Rectangle2D visible = camera.visibleArea();
        for (double i = Math.ceil(visible.getMinX() / step); i * step <= visible.getMaxX(); i++) {
            int x = toPixel(camera.width() / 2.0 + camera.scale() * (i * step - camera.x()));
            context.fill(new Rectangle(x, 0, 1, camera.height()), colour);
        }
        for (double i = Math.ceil(visible.getMinY() / step); i * step <= visible.getMaxY(); i++) {
            int y = toPixel(camera.height() / 2.0 - camera.scale() * (i * step - camera.y()));
            context.fill(new Rectangle(0, y, camera.width(), 1), colour);
        }
    }

    /** Returns the pixel of a coordinate: a thin line that fills it is sharp. */
    private static int toPixel(double coordinate) {
        return (int) Math.floor(coordinate);
    }
}
