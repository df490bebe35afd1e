package faultline.gui.edit;

import faultline.geometry.Vector2;
import java.util.List;

/** Rounds the results of drags and key strokes to nanometres, so that files stay readable. */
public final class Rounding {

    private static final double STEPS_PER_METRE = 1e9;

    private Rounding() {}

    static double round(double value) {
        return Math.rint(value * STEPS_PER_METRE) / STEPS_PER_METRE;
    }

    /** Returns the nearest point on a grid of nanometres. */
    public static Vector2 round(Vector2 value) {
        return new Vector2(round(value.x()), round(value.y()));
    }

    static List<Vector2> round(List<Vector2> values) {
        return values.stream().map(Rounding::round).toList();
    }
}
