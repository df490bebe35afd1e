package faultline.paint.scene;

import faultline.paint.surface.DrawContext;
import faultline.paint.surface.NiceSteps;
import faultline.paint.surface.Palette;
import java.awt.Color;
import java.awt.Shape;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;

/** Paints a scale bar of a nice length in the lower right corner, below the band around a world that just fits. */
final class ScaleBarPainter {

    /** The minimum length of the bar, pixels; it is less than two and a half times as long. */
    private static final double MIN_LENGTH = 60;

    /** The distance of the bar from the right edge of the picture, pixels. */
    private static final double MARGIN_RIGHT = 24;
    /** The distance of the bar from the bottom of the picture, pixels. */
    private static final double MARGIN_BOTTOM = 7;
    /** The height of the marks at the ends of the bar, pixels. */
    private static final double TICK_HEIGHT = 4;
    /** The distance between the bar and its name, pixels. */
    private static final double NAME_GAP = 8;

    private ScaleBarPainter() {}

    /** Returns the area of the bar with its name, pixels. */
    static Rectangle2D area(DrawContext context) {
        double metres = metres(context);
        Rectangle2D name = context.measureText(NiceSteps.format(metres));
        double width = metres * context.camera().scale() + NAME_GAP + name.getWidth();
        double height = Math.max(2 * TICK_HEIGHT, name.getHeight());
        double top = baseline(context) - height / 2;
        return new Rectangle2D.Double(
                right(context) - width, top, width, context.camera().height() - top);
    }

    private static double metres(DrawContext context) {
        return NiceSteps.atLeast(MIN_LENGTH / context.camera().scale());
    }

    private static double right(DrawContext context) {
        return Math.floor(context.camera().width() - MARGIN_RIGHT) + 0.5;
    }

    /** Returns the y coordinate of the bar, pixels. */
    private static double baseline(DrawContext context) {
        return Math.floor(context.camera().height() - MARGIN_BOTTOM) + 0.5;
    }

    static void paint(DrawContext context) {
        double metres = metres(context);
        double length = metres * context.camera().scale();
        double right = right(context);
        double y = baseline(context);
        Shape bar = barShape(right - length, right, y);
        Color halo = Palette.withAlpha(context.palette().canvas(), 200);
        context.draw(bar, halo, DrawContext.solidStroke(5));
        context.draw(bar, context.palette().text(), DrawContext.solidStroke(1.5));
        String name = NiceSteps.format(metres);
        context.drawLabel(
                name,
                right - length - NAME_GAP - context.measureText(name).getWidth() / 2,
                y,
                context.palette().text());
    }

    /** Returns a bar from left to right at a height, with a tick at either end. */
    static Shape barShape(double left, double right, double y) {
        Path2D bar = new Path2D.Double();
        bar.moveTo(left, y - TICK_HEIGHT);
        bar.lineTo(left, y + TICK_HEIGHT);
        bar.moveTo(left, y);
        bar.lineTo(right, y);
        bar.moveTo(right, y - TICK_HEIGHT);
        bar.lineTo(right, y + TICK_HEIGHT);
        return bar;
    }
}
