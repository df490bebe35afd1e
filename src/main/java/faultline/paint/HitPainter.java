package faultline.paint;

import faultline.geometry.Vec;
import java.util.List;

/** Paints the paper's circles: a ring wherever the outline of a cone meets the outline of an obstacle. */
final class HitPainter {

    /** The radius of a ring, pixels. */
    static final double RADIUS = 5;

    private HitPainter() {
    }

    static void paint(Brush brush, List<Vec> hits) {
        for (Vec hit : hits) {
            Vec place = brush.camera().toScreen(hit);
            brush.ring(place.x(), place.y(), RADIUS, 1.8, brush.palette().hit());
        }
    }
}
