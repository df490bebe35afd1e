package faultline.paint.scene;

import faultline.paint.surface.DrawContext;
import faultline.sensor.FaultKind;
import java.awt.Color;
import java.awt.Stroke;

/**
 * Hatches a cone by the kind of its sensor's fault, along its own arcs and rays, so that no clip is needed and faults
 * tell apart without colour.
 */
final class HatchingPainter {

    private static final Stroke LINE_STROKE = DrawContext.solidStroke(1);
    /** The least distance between two arcs, and between two rays where they end, pixels. */
    private static final double MIN_STEP = 8;
    /** No cone has more arcs, or gaps between rays, than these, however large it is on the screen. */
    private static final int MAX_ARCS = 24;

    private static final int MAX_GAPS = 12;

    private HatchingPainter() {}

    /**
     * Arcs for one distance always, rays for a shifted one, broken arcs for one that comes and goes, a mesh for none.
     */
    static void paint(DrawContext brush, ScreenSector cone, FaultKind kind, Color colour) {
        switch (kind) {
            case OFF -> {
                paintArcs(brush, cone, colour, LINE_STROKE);
                paintRays(brush, cone, colour);
            }
            case STUCK -> paintArcs(brush, cone, colour, LINE_STROKE);
            case BIAS -> paintRays(brush, cone, colour);
            case DROPOUT ->
                paintArcs(brush, cone, colour, DrawContext.dashedStroke(1.2, arcStep(cone) / 2, arcStep(cone) / 2));
        }
    }

    private static void paintArcs(DrawContext brush, ScreenSector cone, Color colour, Stroke stroke) {
        double step = arcStep(cone);
        for (double r = step; r < cone.radius(); r += step) {
            brush.draw(cone.arcAt(r / cone.scale()), colour, stroke);
        }
    }

    private static double arcStep(ScreenSector cone) {
        return Math.max(MIN_STEP, cone.radius() / MAX_ARCS);
    }

    private static void paintRays(DrawContext brush, ScreenSector cone, Color colour) {
        double arc = Math.toRadians(cone.extent()) * cone.radius();
        int gaps = (int) Math.max(2, Math.min(MAX_GAPS, Math.round(arc / MIN_STEP)));
        for (int i = 1; i < gaps; i++) {
            brush.draw(cone.ray((double) i / gaps), colour, LINE_STROKE);
        }
    }
}
