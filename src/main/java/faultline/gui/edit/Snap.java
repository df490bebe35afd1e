package faultline.gui.edit;

import faultline.geometry.Vec;

/**
 * To what a hand's places, lengths and angles are rounded.
 *
 * @param step of places and lengths, metres; 0 for as they are
 * @param turn of angles, radians; 0 for as they are
 */
public record Snap(double step, double turn) {

    private static final double FINEST = 1e-5;

    /** Rounds nothing that a hand means. */
    public static final Snap NONE = new Snap(0, 0);

    /**
     * A place on the grid.
     *
     * @param free where the hand is, metres
     * @return the nearest place
     */
    public Vec place(Vec free) {
        return new Vec(length(free.x()), length(free.y()));
    }

    /**
     * A length on the grid.
     *
     * @param free as the hand has it, metres
     * @return the nearest length; without a grid, to the hundredth of a millimetre, because no hand means more
     */
    public double length(double free) {
        return rounded(free, step > 0 ? step : FINEST);
    }

    /**
     * An angle among the allowed ones.
     *
     * @param free as the hand has it, radians
     * @return the nearest angle
     */
    public double angle(double free) {
        return turn > 0 ? rounded(free, turn) : free;
    }

    private static double rounded(double free, double to) {
        return Metres.round(Math.rint(free / to) * to);
    }
}
