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
    private static final Stroke BROKEN = Brush.dashed(1.2, 4, 4);
    /** Between two arcs, pixels. */
    private static final double ARC_STEP = 8;
    /** Between two rays where they end, pixels. */
    private static final double RAY_STEP = 9;

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
            case DROPOUT -> arcs(brush, cone, colour, BROKEN);
        }
    }

    private static void arcs(Brush brush, ScreenSector cone, Color colour, Stroke stroke) {
        for (double r = ARC_STEP; r < cone.radius(); r += ARC_STEP) {
            brush.draw(cone.arcAt(r / cone.scale()), colour, stroke);
        }
    }

    private static void rays(Brush brush, ScreenSector cone, Color colour) {
        int gaps = Math.max(2, (int) Math.round(Math.toRadians(cone.angle()) * cone.radius() / RAY_STEP));
        for (int i = 1; i < gaps; i++) {
            brush.draw(cone.ray((double) i / gaps), colour, LINE);
        }
    }
}
