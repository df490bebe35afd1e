package faultline.paint;

import faultline.world.Snapshot;
import java.awt.BasicStroke;
import java.awt.Stroke;
import java.awt.geom.Rectangle2D;

/** Paints the edge of the world: a band round an enclosed one, whose inner edge is the wall itself, or a fine broken line. */
final class BoundsPainter {

    /** How wide the band is, pixels. */
    static final double BAND = 9;

    private static final Stroke BAND_STROKE = new BasicStroke((float) BAND, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER);
    private static final Stroke EDGE = new BasicStroke(1.4f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER);

    private BoundsPainter() {
    }

    static void paint(Brush brush, Snapshot world) {
        Rectangle2D inside = brush.onScreen(new Rectangle2D.Double(0, 0, world.width(), world.height())).getBounds2D();
        if (world.enclosed()) {
            brush.draw(grown(inside, BAND / 2), brush.palette().obstacle(), BAND_STROKE);
            brush.draw(inside, brush.palette().obstacleOutline(), EDGE);
            brush.draw(grown(inside, BAND), brush.palette().obstacleOutline(), EDGE);
        } else {
            brush.draw(inside, brush.palette().muted(), Brush.dashed(1, 2, 5));
        }
    }

    private static Rectangle2D grown(Rectangle2D r, double by) {
        return new Rectangle2D.Double(r.getX() - by, r.getY() - by, r.getWidth() + 2 * by, r.getHeight() + 2 * by);
    }
}
