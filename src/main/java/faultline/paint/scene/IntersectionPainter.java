package faultline.paint.scene;

import faultline.geometry.Vector2;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.SensorColours;
import java.util.List;

/** Paints the circles of the paper: a ring at each point at which the outlines of a cone and an obstacle intersect. */
final class IntersectionPainter {

    /** The radius of a ring, pixels. */
    static final double RING_RADIUS = 5;

    private IntersectionPainter() {}

    /** Paints the rings of a sensor in its colour. */
    static void paint(DrawContext context, List<Vector2> hits, SensorColours colours) {
        for (Vector2 hit : hits) {
            context.drawRing(context.camera().toScreen(hit), RING_RADIUS, 1.8, colours.outline());
        }
    }
}
