package faultline.paint.scene;

import faultline.geometry.Vector2;
import faultline.paint.surface.DrawContext;
import java.util.List;

/** Paints the paper's circles: a ring wherever the outline of a cone meets the outline of an obstacle. */
final class IntersectionPainter {

    /** The radius of a ring, pixels. */
    static final double RING_RADIUS = 5;

    private IntersectionPainter() {}

    static void paint(DrawContext brush, List<Vector2> hits) {
        for (Vector2 hit : hits) {
            Vector2 place = brush.camera().toScreen(hit);
            brush.drawRing(
                    place.x(), place.y(), RING_RADIUS, 1.8, brush.palette().contact());
        }
    }
}
