package faultline.paint.scene;

import faultline.paint.surface.DrawContext;
import java.awt.BasicStroke;
import java.awt.Stroke;
import java.awt.geom.Rectangle2D;

/**
 * Paints the edge of the world: a band round an enclosed one, whose inner edge is the wall itself, or a fine broken
 * line.
 */
final class BoundsPainter {

    /** How wide the band is, pixels. */
    static final double BAND_WIDTH = 9;

    private static final Stroke BAND_STROKE =
            new BasicStroke((float) BAND_WIDTH, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER);
    private static final Stroke EDGE_STROKE = new BasicStroke(1.4f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER);

    private BoundsPainter() {}

    static void paint(DrawContext brush, double width, double height, boolean enclosed) {
        Rectangle2D inside =
                brush.toScreen(new Rectangle2D.Double(0, 0, width, height)).getBounds2D();
        if (enclosed) {
            brush.draw(expanded(inside, BAND_WIDTH / 2), brush.palette().obstacle(), BAND_STROKE);
            brush.draw(inside, brush.palette().obstacleOutline(), EDGE_STROKE);
            brush.draw(expanded(inside, BAND_WIDTH), brush.palette().obstacleOutline(), EDGE_STROKE);
        } else {
            brush.draw(inside, brush.palette().muted(), DrawContext.dashedStroke(1, 2, 5));
        }
    }

    private static Rectangle2D expanded(Rectangle2D r, double by) {
        return new Rectangle2D.Double(r.getX() - by, r.getY() - by, r.getWidth() + 2 * by, r.getHeight() + 2 * by);
    }
}
