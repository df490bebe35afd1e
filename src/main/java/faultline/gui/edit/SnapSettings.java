package faultline.gui.edit;

import faultline.geometry.Vector2;

/**
 * To what a hand's places, lengths and angles are rounded.
 *
 * @param gridStep of places and lengths, metres; 0 for as they are
 * @param angleStep of angles, radians; 0 for as they are
 */
public record SnapSettings(double gridStep, double angleStep) {

    private static final double MIN_STEP = 1e-5;

    /** Rounds nothing that a hand means. */
    public static final SnapSettings NONE = new SnapSettings(0, 0);

    /**
     * A place on the grid.
     *
     * @param free where the hand is, metres
     * @return the nearest place
     */
    public Vector2 point(Vector2 free) {
        return new Vector2(length(free.x()), length(free.y()));
    }

    /**
     * A length on the grid.
     *
     * @param free as the hand has it, metres
     * @return the nearest length; without a grid, to the hundredth of a millimetre, because no hand means more
     */
    public double length(double free) {
        return roundTo(free, gridStep > 0 ? gridStep : MIN_STEP);
    }

    /**
     * An angle among the allowed ones.
     *
     * @param free as the hand has it, radians
     * @return the nearest angle
     */
    public double angle(double free) {
        return angleStep > 0 ? roundTo(free, angleStep) : free;
    }

    private static double roundTo(double free, double to) {
        return Rounding.round(Math.rint(free / to) * to);
    }
}
