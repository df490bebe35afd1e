package faultline.paint;

import java.awt.Color;
import java.awt.Shape;
import java.awt.geom.Path2D;

/** Paints a bar of a round length in the lower right corner. */
final class ScaleBarPainter {

    /** The bar is at least this long and less than two and a half times, pixels. */
    private static final double LEAST = 60;
    private static final double MARGIN_RIGHT = 24;
    private static final double MARGIN_BELOW = 15;
    private static final double TICK = 4;
    private static final double NAME_GAP = 8;

    private ScaleBarPainter() {
    }

    static void paint(Brush brush) {
        Camera camera = brush.camera();
        double metres = RoundSteps.atLeast(LEAST / camera.scale());
        double length = metres * camera.scale();
        double right = Math.floor(camera.width() - MARGIN_RIGHT) + 0.5;
        double y = Math.floor(camera.height() - MARGIN_BELOW) + 0.5;
        Shape bar = bar(right - length, right, y);
        Color halo = Palette.translucent(brush.palette().canvas(), 200);
        brush.draw(bar, halo, Brush.solid(5));
        brush.draw(bar, brush.palette().text(), Brush.solid(1.5));
        String name = RoundSteps.name(metres);
        brush.label(name, right - length - NAME_GAP - brush.measure(name).getWidth() / 2, y, brush.palette().text());
    }

    private static Shape bar(double left, double right, double y) {
        Path2D bar = new Path2D.Double();
        bar.moveTo(left, y - TICK);
        bar.lineTo(left, y + TICK);
        bar.moveTo(left, y);
        bar.lineTo(right, y);
        bar.moveTo(right, y - TICK);
        bar.lineTo(right, y + TICK);
        return bar;
    }
}
