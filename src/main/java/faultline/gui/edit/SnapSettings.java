package faultline.gui.edit;

import faultline.geometry.Vector2;

/**
 * The steps that positions, lengths and angles of a drag are rounded to.
 *
 * @param gridStep the step of positions and lengths, metres; 0 for none
 * @param angleStep the step of angles, radians; 0 for none
 */
public record SnapSettings(double gridStep, double angleStep) {

    private static final double MIN_STEP = 1e-5;

    /** No snapping. */
    public static final SnapSettings NONE = new SnapSettings(0, 0);

    /** Returns the nearest point on the grid. */
    public Vector2 point(Vector2 free) {
        return new Vector2(length(free.x()), length(free.y()));
    }

    /**
     * Returns the nearest length on the grid; without a grid, to a hundredth of a millimetre, which is finer than a
     * drag.
     */
    public double length(double free) {
        return roundTo(free, gridStep > 0 ? gridStep : MIN_STEP);
    }

    /** Returns the nearest allowed angle. */
    public double angle(double free) {
        return angleStep > 0 ? roundTo(free, angleStep) : free;
    }

    private static double roundTo(double free, double to) {
        return Rounding.round(Math.rint(free / to) * to);
    }
}
