package faultline.paint.scene;

import faultline.paint.surface.DrawContext;
import java.awt.BasicStroke;
import java.awt.Stroke;
import java.awt.geom.Rectangle2D;

/**
 * Paints the bounds of the world: a band around an enclosed one, whose inner edge is the wall, or a thin dashed line.
 */
final class BoundsPainter {

    /** The width of the band, pixels. */
    static final double BAND_WIDTH = 9;

    private static final Stroke BAND_STROKE =
            new BasicStroke((float) BAND_WIDTH, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER);
    private static final Stroke EDGE_STROKE = new BasicStroke(1.4f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER);

    private BoundsPainter() {}

    static void paint(DrawContext context, double width, double height, boolean enclosed) {
        Rectangle2D inside =
                context.toScreen(new Rectangle2D.Double(0, 0, width, height)).getBounds2D();
        if (enclosed) {
            context.draw(expanded(inside, BAND_WIDTH / 2), context.palette().obstacle(), BAND_STROKE);
            context.draw(inside, context.palette().obstacleOutline(), EDGE_STROKE);
            context.draw(expanded(inside, BAND_WIDTH), context.palette().obstacleOutline(), EDGE_STROKE);
        } else {
            context.draw(inside, context.palette().muted(), DrawContext.dashedStroke(1, 2, 5));
        }
    }

    private static Rectangle2D expanded(Rectangle2D r, double by) {
        return new Rectangle2D.Double(r.getX() - by, r.getY() - by, r.getWidth() + 2 * by, r.getHeight() + 2 * by);
    }
}
