package faultline.paint.scene;

import faultline.geometry.Vector2;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.SensorColours;
import java.util.List;

/** Paints the circles of the paper: a ring at each point at which the outlines of a cone and an obstacle intersect. */
final class IntersectionPainter {

    /** The radius of a ring, pixels, and the smallest one, in views of large worlds. */
    static final double RING_RADIUS = 5;

    private static final double MIN_RADIUS = 1.5;
    /** The scale below which rings are smaller, because they would hide the robot, pixels per metre. */
    private static final double MIN_FULL_SCALE = 30;

    private IntersectionPainter() {}

    /** Returns the radius of the rings at a scale in pixels per metre, pixels. */
    static double radius(double scale) {
        return Math.max(MIN_RADIUS, RING_RADIUS * Math.min(1, scale / MIN_FULL_SCALE));
    }

    /** Paints the rings of a sensor in its colour. */
    static void paint(DrawContext context, List<Vector2> hits, SensorColours colours) {
        double radius = radius(context.camera().scale());
        for (Vector2 hit : hits) {
            context.drawRing(context.camera().toScreen(hit), radius, 1.8, colours.outline());
        }
    }
}
