package faultline.paint;

import faultline.sensor.FaultKind;
import java.awt.Color;
import java.awt.Stroke;

/**
 * Hatches a cone by the kind of its sensor's fault, along its own arcs and rays, so that no clip is needed and faults tell apart
 * without colour.
 */
final class Hatching {

    private static final Stroke LINE = Brush.solid(1);
    /** The least distance between two arcs, and between two rays where they end, pixels. */
    private static final double LEAST_STEP = 8;
    /** No cone has more arcs, or gaps between rays, than these, however large it is on the screen. */
    private static final int MOST_ARCS = 24;
    private static final int MOST_GAPS = 12;

    private Hatching() {
    }

    /** Arcs for one distance always, rays for a shifted one, broken arcs for one that comes and goes, a mesh for none. */
    static void paint(Brush brush, ScreenSector cone, FaultKind kind, Color colour) {
        switch (kind) {
            case OFF -> {
                arcs(brush, cone, colour, LINE);
                rays(brush, cone, colour);
            }
            case STUCK -> arcs(brush, cone, colour, LINE);
            case BIAS -> rays(brush, cone, colour);
            case DROPOUT -> arcs(brush, cone, colour, Brush.dashed(1.2, arcStep(cone) / 2, arcStep(cone) / 2));
        }
    }

    private static void arcs(Brush brush, ScreenSector cone, Color colour, Stroke stroke) {
        double step = arcStep(cone);
        for (double r = step; r < cone.radius(); r += step) {
            brush.draw(cone.arcAt(r / cone.scale()), colour, stroke);
        }
    }

    private static double arcStep(ScreenSector cone) {
        return Math.max(LEAST_STEP, cone.radius() / MOST_ARCS);
    }

    private static void rays(Brush brush, ScreenSector cone, Color colour) {
        double arc = Math.toRadians(cone.angle()) * cone.radius();
        int gaps = (int) Math.max(2, Math.min(MOST_GAPS, Math.round(arc / LEAST_STEP)));
        for (int i = 1; i < gaps; i++) {
            brush.draw(cone.ray((double) i / gaps), colour, LINE);
        }
    }
}
