package faultline.paint.scene;

import faultline.geometry.Vector2;
import faultline.paint.surface.DrawContext;
import java.awt.Color;
import java.awt.Shape;
import java.awt.geom.RoundRectangle2D;
import java.util.List;

/** Paints lines of text in a rounded frame, beside room for a symbol. */
final class BadgePainter {

    private static final double PADDING = 8;
    private static final double LINE_HEIGHT = 17;
    /** The distance from the middle of a line of text down to its baseline, pixels. */
    private static final double BASELINE_OFFSET = 4.5;

    private BadgePainter() {}

    /** Returns the height of a badge of some lines, pixels. */
    static double height(DrawContext context, int lines) {
        return context.scaleToFont(LINE_HEIGHT) * lines + PADDING;
    }

    /** Returns the width of a badge, pixels. */
    static double width(DrawContext context, List<String> lines, double symbolWidth) {
        double text = lines.stream()
                .mapToDouble(line -> context.measureText(line).getWidth())
                .max()
                .orElse(0);
        return Math.ceil(text + symbolWidth + 3 * PADDING);
    }

    /** Returns the lines of a badge, each shortened if it would make the badge wider than a width, pixels. */
    static List<String> shortened(DrawContext context, List<String> lines, double symbolWidth, double width) {
        double room = width - symbolWidth - 3 * PADDING;
        return lines.stream().map(line -> context.shortenText(line, room)).toList();
    }

    /** Paints a badge with its upper left corner at a point; returns the middle of the left edge of the symbol. */
    static Vector2 paint(
            DrawContext context, Vector2 corner, List<String> lines, double symbolWidth, Color edge, double edgeWidth) {
        double width = width(context, lines, symbolWidth);
        Shape frame = new RoundRectangle2D.Double(
                corner.x() + 0.5, corner.y() + 0.5, width, height(context, lines.size()), 8, 8);
        context.fill(frame, context.palette().canvas());
        context.draw(frame, edge, DrawContext.solidStroke(edgeWidth));
        double middle = corner.y() + 0.5 + height(context, 1) / 2;
        for (int i = 0; i < lines.size(); i++) {
            context.drawText(
                    lines.get(i),
                    corner.x() + 2 * PADDING + symbolWidth,
                    middle + context.scaleToFont(BASELINE_OFFSET) + i * context.scaleToFont(LINE_HEIGHT),
                    context.palette().text());
        }
        return new Vector2(corner.x() + PADDING, middle);
    }
}
