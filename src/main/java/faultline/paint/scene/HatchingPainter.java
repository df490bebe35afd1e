package faultline.paint.scene;

import faultline.paint.surface.DrawContext;
import faultline.sensor.FaultKind;
import java.awt.Color;
import java.awt.Stroke;

/**
 * Hatches a cone by the kind of its sensor's fault, along its own arcs and rays, so that no clip is needed and faults
 * can be distinguished without colour.
 */
final class HatchingPainter {

    private static final Stroke LINE_STROKE = DrawContext.solidStroke(1);
    /** The minimum distance between two arcs, and between the ends of two rays, pixels. */
    private static final double MIN_STEP = 8;
    /** The maximum number of arcs of a cone, however large it is on the screen. */
    private static final int MAX_ARCS = 24;

    private static final int MAX_GAPS = 12;

    private HatchingPainter() {}

    /**
     * Paints arcs for a constant distance, rays for a shifted one, dashed arcs for intermittent readings, and a mesh
     * for none.
     */
    static void paint(DrawContext context, ScreenSector cone, FaultKind kind, Color colour) {
        switch (kind.family()) {
            case SILENT -> {
                paintArcs(context, cone, colour, LINE_STROKE);
                paintRays(context, cone, colour);
            }
            case CONSTANT -> paintArcs(context, cone, colour, LINE_STROKE);
            case SHIFTED -> paintRays(context, cone, colour);
            case INTERMITTENT ->
                paintArcs(context, cone, colour, DrawContext.dashedStroke(1.2, arcStep(cone) / 2, arcStep(cone) / 2));
        }
    }

    private static void paintArcs(DrawContext context, ScreenSector cone, Color colour, Stroke stroke) {
        double step = arcStep(cone);
        for (double r = step; r < cone.radius(); r += step) {
            context.draw(cone.arcAt(r / cone.scale()), colour, stroke);
        }
    }

    private static double arcStep(ScreenSector cone) {
        return Math.max(MIN_STEP, cone.radius() / MAX_ARCS);
    }

    private static void paintRays(DrawContext context, ScreenSector cone, Color colour) {
        double arc = Math.toRadians(cone.extent()) * cone.radius();
        int gaps = (int) Math.max(2, Math.min(MAX_GAPS, Math.round(arc / MIN_STEP)));
        for (int i = 1; i < gaps; i++) {
            context.draw(cone.ray((double) i / gaps), colour, LINE_STROKE);
        }
    }
}
